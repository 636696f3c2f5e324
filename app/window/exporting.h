// Files of what is shown. Names count up, so that nothing is overwritten.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/panels/edit.h"
#include "app/report/json_values.h"
#include "viz/text.h"

namespace kd {

/// `folder`/kdscope-N`extension` with the least N for which no kdscope-N file of any kind is there.
[[nodiscard]] std::filesystem::path next_file(const std::filesystem::path& folder, const std::string& extension);

/// Of the picture shown, as the function of this name in app/report/frame_summary.h.
[[nodiscard]] Json summary_json(const EngineState& state, const std::optional<MeasuredOn>& on = {});

/// Everything but Action::export_window; of Action::save_session all that is chosen now, of others what is shown.
/// Returns the path written. InputError.
[[nodiscard]] std::filesystem::path export_file(Action what, const EngineState& state,
                                                const std::filesystem::path& folder, const Font& font,
                                                const std::function<void(float)>& progress = {});

/// A picture of the whole window, rows from the top. InputError.
[[nodiscard]] std::filesystem::path export_window(const Image<Rgba8>& window, const EngineState& state,
                                                  const std::filesystem::path& folder);

}  // namespace kd
