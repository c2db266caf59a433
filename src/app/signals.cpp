#include "signals.hpp"

#include <array>
#include <csignal>
#include <cstring>

namespace weavefront::app {

namespace {

constexpr std::array noted{SIGTERM, SIGINT, SIGUSR1, SIGUSR2};

volatile std::sig_atomic_t first_noted = 0;

extern "C" void note_signal(int signal) {
    if (first_noted == 0) first_noted = signal;
    if (signal == SIGINT) std::signal(SIGINT, SIG_DFL);  // a second one is not waited for
}

}  // namespace

void ignore_failed_writes() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void note_signals() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = SA_RESTART;
    for (const int signal : noted) sigaction(signal, &action, nullptr);
}

int noted_signal() { return first_noted; }

std::string name_of_signal(int signal) { return std::string("SIG") + sigabbrev_np(signal); }

}  // namespace weavefront::app
