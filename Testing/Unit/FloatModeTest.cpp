// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/FloatMode.h"

#include "Testing/Unit/TestScene.h"

#include <cfenv>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace limn::testing {
namespace {

/// What a host program may have set: rounding upward, denormals flushed and taken for zero.
class StrangeMode {
 public:
  StrangeMode()
  {
    std::fegetenv(&saved_);
    std::fesetround(FE_UPWARD);
#if defined(__x86_64__)
    constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
    _mm_setcsr(_mm_getcsr() | kFlushToZero | kDenormalsAreZero);
#endif
  }
  ~StrangeMode()
  {
    std::fesetenv(&saved_);
  }
  StrangeMode(const StrangeMode&) = delete;
  StrangeMode& operator=(const StrangeMode&) = delete;

 private:
  std::fenv_t saved_;
};

/// True while the mode rounds upward and loses denormals.
bool isStrange()
{
  volatile float one = 1.0f, tiny = 1e-30f, smallest = 1.17549435e-38f;
  const bool upward = one + tiny > 1.0f;
#if defined(__x86_64__)
  const bool flushed = smallest * 0.5f == 0.0f;
  return upward && flushed;
#else
  static_cast<void>(smallest);
  return upward;
#endif
}

TEST(FloatMode, RoundsToNearestAndKeepsDenormalsThenRestores)
{
  const StrangeMode host;
  ASSERT_TRUE(isStrange());
  {
    const FloatMode mode;
    volatile float one = 1.0f, tiny = 1e-30f, smallest = 1.17549435e-38f;
    EXPECT_EQ(one + tiny, 1.0f);
    EXPECT_GT(smallest * 0.5f, 0.0f);
  }
  EXPECT_TRUE(isStrange());
}

class FloatModeOfRender : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(FloatModeOfRender);

TEST_P(FloatModeOfRender, ThePictureDoesNotDependOnTheHostsModeAndTheModeIsKept)
{
  Stage stage;
  stage.view.eye = {1.1, 0.9, 2.6};
  stage.instances = {instanceOf(fineSphere())};
  stage.instances[0].style.reflection = Reflection::kPhong;
  stage.instances[0].material.specular = 0.5f;
  stage.instances[0].material.specularPower = 30;
  stage.lights = {Light{}};
  stage.samples = 4;
  const Picture expected = draw(stage);
  const Scene scene = stage.scene();
  Picture picture(stage.width, stage.height);
  {
    const StrangeMode host;
    EXPECT_TRUE(render(scene, picture.frame(Background::kBlend), {GetParam(), 2}).ok());
    EXPECT_TRUE(isStrange());
  }
  EXPECT_EQ(picture.differingPixels(expected), 0u);
}

}  // namespace
}  // namespace limn::testing
