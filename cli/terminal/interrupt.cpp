#include "cli/terminal/interrupt.hpp"

#include <csignal>

namespace cardioid::cli {
namespace {

volatile std::sig_atomic_t wanted = 0;

}  // namespace

void make_write_errors_visible() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void catch_interrupts() {
    struct sigaction action = {};
    action.sa_handler = [](int) {
        wanted = 1;
        // Both fall back, so that a second signal of either kind ends the program.
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
    };
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() noexcept { return wanted != 0; }

}  // namespace cardioid::cli
