// A screen nobody sees: Xvfb, somebody to press keys (xdotool), and a camera (ImageMagick's
// import).
#pragma once

#include "renderer/imaging/encoded_image.h"

#include <sys/types.h>

#include <string>
#include <vector>

namespace tests {

/// An X server of its own for one test; DISPLAY names it while it lives.
class VirtualScreen {
  public:
    VirtualScreen(int width, int height);
    ~VirtualScreen();
    VirtualScreen(const VirtualScreen&) = delete;
    VirtualScreen& operator=(const VirtualScreen&) = delete;

    void press(const std::string& key) const;
    void click(int x, int y) const;
    renderer::imaging::EncodedImage photograph() const;

  private:
    pid_t server_ = -1;
};

/// Somebody at the keyboard all the time: keys without starting a program for each.
class Typist {
  public:
    Typist();
    ~Typist();
    Typist(const Typist&) = delete;
    Typist& operator=(const Typist&) = delete;

    void press(const std::string& key);

  private:
    pid_t process_ = -1;
    int commands_ = -1;
};

/// A program running beside the test.
class RunningProgram {
  public:
    explicit RunningProgram(const std::vector<std::string>& command, const std::string& err_file);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    bool is_running();
    void kill_at_once();

    /// Exit status once it has ended; 128 + signal when it was killed.
    int status() const { return status_; }

  private:
    pid_t process_ = -1;
    int status_ = -1;
};

} // namespace tests
