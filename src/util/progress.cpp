#include "util/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "util/text.h"

namespace carom {

void print_to_stderr(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

std::string clock_text(double seconds) {
    const auto whole = static_cast<long>(std::lround(seconds));
    if (whole >= 3600)
        return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

Progress::Form Progress::fitting_form(bool quiet) {
    if (quiet) return Form::silent;
    return isatty(STDERR_FILENO) ? Form::bar : Form::lines;
}

Progress::Progress(Form form, std::string name) : form_(form), name_(printable(name)) {}

Progress::~Progress() { finish(); }

void Progress::begin(std::string stage, double total, std::string unit) {
    const std::scoped_lock lock(mutex_);
    stage_ = std::move(stage);
    unit_ = std::move(unit);
    total_ = total;
    done_ = 0;
    begun_ = shown_ = Clock::now();
}

void Progress::advance(double more) {
    if (form_ == Form::silent) return;
    const std::scoped_lock lock(mutex_);
    done_ += more;
    show_now_and_then();
}

void Progress::reach(double done) {
    if (form_ == Form::silent) return;
    const std::scoped_lock lock(mutex_);
    done_ = done;
    show_now_and_then();
}

void Progress::show_now_and_then() {
    const auto now = Clock::now();
    const auto pause =
        form_ == Form::bar ? std::chrono::milliseconds(100) : std::chrono::seconds(4);
    if (done_ > 0.0 && now - shown_ >= pause) show(now);
}

std::string Progress::line(double elapsed) const {
    constexpr double longest = 1e9;  // seconds
    const double speed = done_ / elapsed;
    const double left = std::min((total_ - done_) / speed, longest);
    return fmt::format("{}: {} {:.6g}/{:.6g} {}, {:.3g} {}/s, {} left", name_, stage_, done_,
                       total_, unit_, speed, unit_, clock_text(left));
}

void Progress::show(Clock::time_point now) {
    shown_ = now;
    const std::string text = line(std::chrono::duration<double>(now - begun_).count());
    if (form_ == Form::lines) {
        print_to_stderr(text + "\n");
        return;
    }
    constexpr std::size_t width = 24;
    const auto filled = static_cast<std::size_t>(width * done_ / total_);
    std::string bar;
    for (std::size_t i = 0; i < width; ++i) bar += i < filled ? "█" : "░";
    print_to_stderr(fmt::format("\r\033[K{} {}", bar, text));
    bar_stands_ = true;
}

void Progress::finish() {
    const std::scoped_lock lock(mutex_);
    if (!bar_stands_) return;
    print_to_stderr("\r\033[K");
    bar_stands_ = false;
}

}  // namespace carom
