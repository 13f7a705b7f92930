// Shows the progress of long work on standard error: a bar on a terminal, a line every few seconds
// elsewhere, or nothing.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace carom {

class Progress {
  public:
    enum class Form { bar, lines, silent };

    /// A bar if standard error is a terminal, else lines; nothing if `quiet`.
    static Form fitting_form(bool quiet);

    Progress(Form form, std::string name);
    ~Progress();  ///< clears an unfinished bar
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Begins a stage of `total` frames, or of another `unit` that is counted or measured.
    void begin(std::string stage, double total, std::string unit = "frames");
    void advance(double more = 1.0);  ///< adds to what is done; may be called from any thread
    void reach(double done);          ///< sets what is done, out of the total
    void finish();                    ///< clears the bar

  private:
    using Clock = std::chrono::steady_clock;
    void show_now_and_then();
    void show(Clock::time_point now);
    std::string line(double elapsed) const;

    Form form_;
    std::string name_;
    std::string stage_;
    std::string unit_;
    double total_ = 0.0;
    double done_ = 0.0;
    bool bar_stands_ = false;
    Clock::time_point begun_;
    Clock::time_point shown_;
    std::mutex mutex_;
};

/// Writes to standard error. Errors in writing are ignored.
void print_to_stderr(const std::string& text);

/// Seconds as 0:07, 12:34 or 1:02:03.
std::string clock_text(double seconds);

}  // namespace carom
