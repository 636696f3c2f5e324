#include "app/engine/background.h"

#include <utility>

#include "app/cli/error_text.h"

namespace kd {

void BackgroundRun::start(std::string what, Job job, std::function<void(const std::string& error)> ended) {
    const Post post = [this, ticket = ++ticket_](std::function<void()> change) {
        mailbox_.post([this, ticket, change = std::move(change)] {
            if (ticket == ticket_) change();
        });
    };
    worker_.submit(
        [what = std::move(what), job = std::move(job), ended = std::move(ended), post](const std::stop_token& stop) {
            std::string error;
            try {
                job(stop, post);
            } catch (const std::exception& e) {
                error = error_text(e, what);
            }
            post([ended, error] { ended(error); });
        });
}

void BackgroundRun::cancel() {
    worker_.cancel();
    ++ticket_;
}

}  // namespace kd
