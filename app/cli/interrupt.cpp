#include "app/cli/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include "app/cli/command.h"

namespace kd {

Interrupt::Interrupt() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    watcher_ = std::jthread([this](const std::stop_token& end) {
        int number = 0;
        while (sigwait(&signals_, &number) == 0 && !end.stop_requested()) {
            if (stop_.stop_requested()) ::_exit(exit_interrupted);
            stop_.request_stop();
        }
    });
}

Interrupt::~Interrupt() {
    watcher_.request_stop();
    pthread_kill(watcher_.native_handle(), SIGTERM);  // wakes it
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace kd
