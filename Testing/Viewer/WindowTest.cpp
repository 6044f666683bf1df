// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include <gtest/gtest.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <optional>
#include <thread>

namespace limn::testing
{
namespace
{

using Words = std::vector<std::string>;

constexpr std::chrono::seconds kPatience{ 30 };

/// Waits until `isDone`, and says whether that came true.
bool waitUntil(const std::function<bool()>& isDone)
{
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!isDone())
  {
    if (std::chrono::steady_clock::now() > end)
      return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

/// The X server, with a test's eyes and hands.
class Screen
{
public:
  Screen() : display_(XOpenDisplay(nullptr)) { XSetErrorHandler(ignoreError); }
  ~Screen() { XCloseDisplay(display_); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// The window whose title begins with `start`.
  std::optional<Window> find(const std::string& start)
  {
    return findUnder(DefaultRootWindow(display_), start);
  }

  std::string title(Window window)
  {
    char* text = nullptr;
    XFetchName(display_, window, &text);
    const std::string title = text ? text : "";
    XFree(text);
    return title;
  }

  void press(Window window, KeySym key)
  {
    XEvent event = {};
    event.xkey.type = KeyPress;
    event.xkey.display = display_;
    event.xkey.window = window;
    event.xkey.root = DefaultRootWindow(display_);
    event.xkey.same_screen = True;
    event.xkey.keycode = XKeysymToKeycode(display_, key);
    XSendEvent(display_, window, False, KeyPressMask, &event);
    XFlush(display_);
  }

  /// The pixels of the window, row by row.
  std::vector<unsigned long> pixels(Window window)
  {
    XWindowAttributes size;
    XGetWindowAttributes(display_, window, &size);
    XImage* const image = XGetImage(display_, window, 0, 0, static_cast<unsigned>(size.width),
      static_cast<unsigned>(size.height), AllPlanes, ZPixmap);
    std::vector<unsigned long> pixels;
    for (int y = 0; image && y < size.height; ++y)
    {
      for (int x = 0; x < size.width; ++x)
        pixels.push_back(XGetPixel(image, x, y));
    }
    if (image)
      XDestroyImage(image);
    return pixels;
  }

private:
  /// Windows may go between being listed and being asked.
  static int ignoreError(Display*, XErrorEvent*) { return 0; }

  std::optional<Window> findUnder(Window parent, const std::string& start)
  {
    if (title(parent).rfind(start, 0) == 0)
      return parent;
    Window root = 0;
    Window* children = nullptr;
    unsigned count = 0;
    std::optional<Window> found;
    if (XQueryTree(display_, parent, &root, &parent, &children, &count))
    {
      for (unsigned i = 0; i < count && !found; ++i)
        found = findUnder(children[i], start);
      if (children)
        XFree(children);
    }
    return found;
  }

  Display* display_;
};

Environment withDisplay()
{
  return { { "DISPLAY", std::getenv("DISPLAY") } };
}

TEST(GlWindow, DrawsThePictureOfTheGlFreeWindow)
{
  const Folder folder;
  for (const std::string window : { "cpu", "gl" })
  {
    const Outcome outcome = runLimn(
      { "render", meshFile("teapot.obj"), "--tone=gooch", "--samples=1", "--resolution=200,120",
        "--window=" + window, "--output=" + folder.file(window + ".png") },
      withDisplay());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }
  const Outcome same = runLimn({ "compare", folder.file("cpu.png"), folder.file("gl.png") });
  EXPECT_EQ(same.status, 0) << same.out;
}

TEST(GlWindow, TheOptionWinsOverTheEnvironment)
{
  const Folder folder;
  Environment environment = withDisplay();
  environment["LIMN_WINDOW"] = "gl";
  const Words render = { "render", meshFile("cube.obj"), "--samples=8", "--resolution=200,120" };
  Words cpu = render;
  cpu.push_back("--output=" + folder.file("cpu.png"));
  ASSERT_EQ(runLimn(cpu, environment).status, 0);
  environment["LIMN_WINDOW"] = "cpu";
  Words gl = render;
  gl.push_back("--window=gl");
  gl.push_back("--output=" + folder.file("gl.png"));
  ASSERT_EQ(runLimn(gl, environment).status, 0);
  // The OpenGL of a virtual X server has at most four samples per pixel.
  EXPECT_EQ(runLimn({ "compare", folder.file("cpu.png"), folder.file("gl.png") }).status, 3);
}

/// `limn view` on the teapot, from its first picture until it is closed.
class View : public ::testing::Test
{
protected:
  View() : child_(startLimn({ "view", meshFile("teapot.obj"), "--resolution=300,200" }, err_))
  {
    waitUntil([this] { return screen_.find("limn: teapot.obj").has_value(); });
    window_ = screen_.find("limn: teapot.obj").value_or(0);
    waitUntil([this] { return hasPicture(); });
  }

  ~View() override
  {
    if (!hasEnded_)
    {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
  }

  /// The teapot is there: not all pixels are one colour.
  bool hasPicture()
  {
    const auto pixels = screen_.pixels(window_);
    return std::any_of(
      pixels.begin(), pixels.end(), [&](unsigned long pixel) { return pixel != pixels.front(); });
  }

  /// Presses the key and waits for the title to tell of `state` and for the pixels to change.
  void expectChange(KeySym key, const std::string& state)
  {
    const auto before = screen_.pixels(window_);
    screen_.press(window_, key);
    const bool isTold = waitUntil(
      [&] { return screen_.title(window_).find("| " + state + " |") != std::string::npos; });
    EXPECT_TRUE(isTold) << state << " not in: " << screen_.title(window_);
    EXPECT_TRUE(waitUntil([&] { return screen_.pixels(window_) != before; })) << state;
  }

  Folder folder_;
  std::string err_ = folder_.file("err");
  Screen screen_;
  pid_t child_;
  Window window_ = 0;
  bool hasEnded_ = false;
};

TEST_F(View, KeysSwitchTheLook)
{
  ASSERT_NE(window_, 0u);
  EXPECT_NE(screen_.title(window_).find("| shading phong | reflection blinn-phong | tone none | "
                                        "outline none | samples 4 |"),
    std::string::npos)
    << screen_.title(window_);
  expectChange(XK_s, "shading flat");
  expectChange(XK_s, "shading gouraud");
  expectChange(XK_s, "shading phong");
  expectChange(XK_l, "reflection irradiance");
  expectChange(XK_l, "reflection oren-nayar");
  expectChange(XK_l, "reflection metallic");
  expectChange(XK_l, "reflection none");
  expectChange(XK_l, "reflection lambert");
  expectChange(XK_t, "tone gooch");
  expectChange(XK_t, "tone gooch-chapter");
  expectChange(XK_t, "tone gooch-rtr4");
  expectChange(XK_t, "tone gooch-orange-book");
  expectChange(XK_t, "tone metal");
  expectChange(XK_t, "tone toon");
  expectChange(XK_t, "tone hatching");
  expectChange(XK_t, "tone exaggerated");
  expectChange(XK_t, "tone none");
  expectChange(XK_o, "outline normal");
  expectChange(XK_o, "outline hull");
  expectChange(XK_o, "outline image");
  expectChange(XK_o, "outline none");
  expectChange(XK_y, "style plain");
  expectChange(XK_y, "style technical");
  expectChange(XK_y, "style gooch");
}

TEST_F(View, QEndsTheProgramWithoutAnError)
{
  ASSERT_NE(window_, 0u);
  screen_.press(window_, XK_q);
  int status = -1;
  hasEnded_ = waitUntil([&] { return waitpid(child_, &status, WNOHANG) == child_; });
  ASSERT_TRUE(hasEnded_);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(bytesOf(err_), "");
}

} // namespace
} // namespace limn::testing
