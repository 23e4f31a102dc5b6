// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/fp_environment.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <thread>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace triplex {
namespace {

// Restores the thread's environment whatever the test did to it.
class FpEnvironment : public ::testing::Test {
 protected:
  void SetUp() override { std::fegetenv(&saved_); }
  void TearDown() override { std::fesetenv(&saved_); }

 private:
  std::fenv_t saved_;
};

TEST_F(FpEnvironment, DefaultIsAccepted) { EXPECT_EQ(check_fp_environment(), std::nullopt); }

TEST_F(FpEnvironment, DirectedRoundingIsDetectedAndGuarded) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const auto outside = check_fp_environment();
    std::optional<std::string> inside = "not run";
    {
      const FpEnvironmentGuard guard;
      inside = check_fp_environment();
    }
    const auto after = check_fp_environment();
    EXPECT_EQ(with_fp_environment(check_fp_environment), std::nullopt);
    EXPECT_EQ(std::fegetround(), mode);
    ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
    ASSERT_TRUE(outside.has_value());
    EXPECT_NE(outside->find("nearest"), std::string::npos) << *outside;
    EXPECT_EQ(inside, std::nullopt);
    EXPECT_EQ(after, outside);
  }
}

#if defined(__SSE2__)

constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040, kDivisionTrapMask = 0x0200;

TEST_F(FpEnvironment, FlushToZeroIsDetectedAndGuarded) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | kFlushToZero);
  const auto outside = check_fp_environment();
  const auto inside = with_fp_environment(check_fp_environment);
  const unsigned restored = _mm_getcsr();
  _mm_setcsr(before);
  ASSERT_TRUE(outside.has_value());
  EXPECT_NE(outside->find("flushed"), std::string::npos) << *outside;
  EXPECT_EQ(inside, std::nullopt);
  EXPECT_EQ(restored & kFlushToZero, kFlushToZero);
}

TEST_F(FpEnvironment, DenormalsAreZeroIsDetectedAndGuarded) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | kDenormalsAreZero);
  const auto outside = check_fp_environment();
  const auto inside = with_fp_environment(check_fp_environment);
  const unsigned restored = _mm_getcsr();
  _mm_setcsr(before);
  ASSERT_TRUE(outside.has_value());
  EXPECT_NE(outside->find("taken as zero"), std::string::npos) << *outside;
  EXPECT_EQ(inside, std::nullopt);
  EXPECT_EQ(restored & kDenormalsAreZero, kDenormalsAreZero);
}

TEST_F(FpEnvironment, GuardMasksTrapsAndRestoresFlags) {
  const unsigned unmasked = _mm_getcsr() & ~kDivisionTrapMask & ~0x3Fu;
  _mm_setcsr(unmasked);
  volatile double zero = 0.0;
  const double quotient = with_fp_environment([&] { return 1.0 / zero; });  // must not trap
  EXPECT_EQ(_mm_getcsr(), unmasked);
  EXPECT_TRUE(std::isinf(quotient));
}

#endif

TEST_F(FpEnvironment, EachThreadHasItsOwn) {
  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  std::optional<std::string> in_thread;
  std::thread([&] {  // a new thread inherits its parent's environment
    in_thread = with_fp_environment(check_fp_environment);
  })
      .join();
  const int here = std::fegetround();
  ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
  EXPECT_EQ(in_thread, std::nullopt);
  EXPECT_EQ(here, FE_UPWARD);
}

}  // namespace
}  // namespace triplex
