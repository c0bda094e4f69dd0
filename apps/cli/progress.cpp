#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <nlohmann/json.hpp>

namespace plico::cli {
namespace {

void put(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

// Lets a report through when its phase is new or finished or `interval` has passed; workers may report concurrently.
class Paced : public ShownProgress {
 public:
  explicit Paced(std::chrono::milliseconds interval) : interval_(interval) {}

  void report(std::string_view phase, long done, long total, std::string_view note) final {
    const std::lock_guard lock(mutex_);
    const auto now = Run::Clock::now();
    const bool finished = total > 0 && done >= total;
    if (phase == phase_ && !finished && now < next_) return;
    if (phase != phase_) begun_ = now;
    phase_ = phase;
    next_ = now + interval_;
    show(phase, done, total, note);
  }

 protected:
  // Of the phase, from how it went so far; empty as long as that says little.
  std::string remaining(long done, long total) const {
    const double passed = std::chrono::duration<double>(Run::Clock::now() - begun_).count();
    if (done <= 0 || done >= total || passed < 2) return "";
    return fmt::format(", {:.0f} s left", std::ceil(passed * double(total - done) / double(done)));
  }
  std::mutex& mutex() { return mutex_; }

 private:
  virtual void show(std::string_view phase, long done, long total, std::string_view note) = 0;

  std::chrono::milliseconds interval_;
  std::mutex mutex_;
  std::string phase_;
  Run::Clock::time_point next_, begun_;
};

std::string in_words(std::string_view phase, long done, long total, std::string_view note) {
  std::string text = total > 0 ? fmt::format("{} {} of {}", phase, done, total) : fmt::format("{} {}", phase, done);
  if (!note.empty()) text += fmt::format(", {}", note);
  return text;
}

class Bar : public Paced {
 public:
  Bar() : Paced(std::chrono::milliseconds(100)) {}
  ~Bar() override { erase(); }

  void erase() override {
    const std::lock_guard lock(mutex());
    if (drawn_) put("\r\x1b[K");
    drawn_ = false;
  }

 private:
  void show(std::string_view phase, long done, long total, std::string_view note) override {
    constexpr int kWidth = 24;
    std::string bar;
    if (total > 0) {
      const int filled = static_cast<int>(std::clamp<double>(double(done) / double(total), 0, 1) * kWidth);
      bar = fmt::format("[{}{}] ", std::string(filled, '#'), std::string(kWidth - filled, '.'));
    }
    // One terminal line of the usual width: a longer one would scroll instead of being redrawn.
    put("\r\x1b[K" + (bar + in_words(phase, done, total, note) + remaining(done, total)).substr(0, 79));
    drawn_ = true;
  }

  bool drawn_ = false;
};

class Plain : public Paced {
 public:
  Plain() : Paced(std::chrono::seconds(1)) {}

 private:
  void show(std::string_view phase, long done, long total, std::string_view note) override {
    put(in_words(phase, done, total, note) + "\n");
  }
};

class Phases : public Paced {
 public:
  Phases() : Paced(std::chrono::hours(1)) {}

 private:
  void show(std::string_view phase, long, long, std::string_view) override {
    if (phase == last_) return;
    last_ = phase;
    put(fmt::format("{:8.2f} s  {}\n", std::chrono::duration<double>(Run::Clock::now() - start_).count(), phase));
  }

  std::string last_;
  Run::Clock::time_point start_ = Run::Clock::now();
};

class Json : public Paced {
 public:
  Json() : Paced(std::chrono::milliseconds(200)) {}

 private:
  void show(std::string_view phase, long done, long total, std::string_view note) override {
    nlohmann::json line = {{"phase", phase}, {"done", done}};
    if (total > 0) line["total"] = total;
    if (!note.empty()) line["note"] = note;
    put(line.dump() + "\n");
  }
};

}  // namespace

std::unique_ptr<ShownProgress> make_progress(const std::string& style) {
  if (style == "bar" || (style == "auto" && isatty(STDERR_FILENO))) return std::make_unique<Bar>();
  if (style == "plain") return std::make_unique<Plain>();
  if (style == "phases") return std::make_unique<Phases>();
  if (style == "json") return std::make_unique<Json>();
  return nullptr;
}

}  // namespace plico::cli
