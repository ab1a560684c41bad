#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace fairlight {

/// What a judge of a mean is given. Draws are in units of what is claimed of them, so that their mean should be 1, as in the scenes
/// that absolute tolerances are made for. The variances are known beforehand, of right code, as those of a reference picture are.
struct JudgedDraws {
  std::vector<std::span<const double>> channels;
  std::vector<double> variances;  ///< of one draw, a channel
};

/// pbrt-v4: the average over all channels is within 0.025 of 1. Its variance is not looked at.
/// Source   src/pbrt/cpu/integrators_test.cpp, CheckSceneAverage
bool fails_by_pbrt(const JudgedDraws& draws);

/// Mitsuba 3: a z-test in every pixel and channel, with the variance of the reference, which is at least 1e-4, at 1 % corrected after
/// Sidak for the number of pixels; 99.75 % of the pixels must pass. Draws are dealt to the pixels of a picture in equal parts,
/// consecutive ones to a pixel; fewer draws than pixels make a smaller picture.
/// Source   src/render/tests/test_renders.py, test_render; the smallest pictures found in its tests have 48 x 48 pixels
bool fails_by_mitsuba(const JudgedDraws& draws, std::size_t pixels = std::size_t{48} * 48);

/// Nori: Student's t-test with a variance of at least 1e-5, at 1 % corrected after Sidak for the number of tests in a file: the
/// channels of a claim are such a file.
/// Source   src/ttest.cpp; hypothesis.h, students_t_test
bool fails_by_nori(const JudgedDraws& draws);

/// OpenMC: the mean of every channel is within four standard errors; a test that fails is run once more, and fails if that does. The
/// first half of the draws is the first run.
/// Source   tests/unit_tests/__init__.py, assert_sample_mean; test_stats.py, flaky(reruns=1)
bool fails_by_openmc(const JudgedDraws& draws);

/// Abseil: z-tests in 100 trials, each of which right code passes with probability 0.99^(1/100); at most max(1, 1 %) of them may
/// fail. Consecutive parts of a channel's draws are its trials.
/// Source   absl/random/gaussian_distribution_test.cc, ZTest; internal/distribution_test_util.cc
bool fails_by_abseil(const JudgedDraws& draws, std::size_t trials = 100);

/// Somebody's rule of when a Monte Carlo test has failed.
struct Judge {
  std::string name;
  bool (*fails)(const JudgedDraws& draws);
};

const std::vector<Judge>& judges();

}  // namespace fairlight
