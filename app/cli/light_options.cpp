// The options of sampled light.
#include <fmt/format.h>

#include "app/cli/common_options.h"
#include "app/cli/idle_options.h"
#include "app/cli/typed_options.h"

namespace kd {

void add_light_options(CLI::App& app, CommonOptions& o) {
    Sampling& sampling = o.session.trace.sampling;
    const auto without = [&](const char* name, bool& effect, const char* what) {
        return app.add_flag_callback(
            name, [&effect] { effect = false; }, what);
    };
    for (CLI::Option* option :
         {add_number(app, "--samples", o.session.samples, limits::samples,
                     "Samples of light for each pixel; 0 is the paper's one ray towards each light's middle [0]"),
          add_number(app, "--sample-error", o.session.sample_error, limits::share,
                     "Standard error, of white 1, at which a tile gets no more samples; 0 is none [0]"),
          without("--no-soft-shadows", sampling.soft_shadows, "Lights are points though light is sampled"),
          without("--no-gloss", sampling.gloss, "What reflects is a mirror though light is sampled"),
          without("--no-indirect", sampling.indirect, "No light from other surfaces though light is sampled")})
        option->group("Light");
}

void refuse_idle_light_options(const CLI::App& app, const Session& session) {
    const std::string why = "light is not sampled; add --samples N";
    for (const char* option : {"--sample-error", "--no-soft-shadows", "--no-gloss", "--no-indirect"})
        refuse_idle(app, {{option, session.samples > 0, why}});
}

}  // namespace kd
