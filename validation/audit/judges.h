#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace fairlight {

/// The draws that a judge tests. They are shifted and scaled so that their mean should be 1, as in
/// the scenes that absolute tolerances are made for. The variances come from right code beforehand,
/// as those of a reference picture do.
struct JudgedDraws {
  std::vector<std::span<const double>> channels;
  std::vector<double> variances;  ///< of one draw, for each channel
};

/// pbrt-v4: passes if the average over all channels is within 0.025 of 1. Ignores the variance.
/// Source   src/pbrt/cpu/integrators_test.cpp, CheckSceneAverage
bool fails_by_pbrt(const JudgedDraws& draws);

/// Mitsuba 3: a z-test in every pixel and channel, with the variance of the reference but at least
/// 1e-4, at 1 % with Sidak's correction for the number of pixels. 99.75 % of the pixels must pass.
/// Each pixel gets an equal number of consecutive draws; fewer draws than pixels make a smaller
/// picture.
/// Source   src/render/tests/test_renders.py, test_render (whose smallest pictures have 48 x 48
///          pixels)
bool fails_by_mitsuba(const JudgedDraws& draws, std::size_t pixels = std::size_t{48} * 48);

/// Nori: Student's t-test with a variance of at least 1e-5, at 1 % with Sidak's correction for the
/// number of tests in a file. The channels of a claim count as the tests of a file.
/// Source   src/ttest.cpp; hypothesis.h, students_t_test
bool fails_by_nori(const JudgedDraws& draws);

/// OpenMC: the mean of every channel must be within four standard errors. A test that fails runs
/// once more, and fails if the second run does. The halves of the draws are the two runs.
/// Source   tests/unit_tests/__init__.py, assert_sample_mean; test_stats.py, flaky(reruns=1)
bool fails_by_openmc(const JudgedDraws& draws);

/// Abseil: z-tests in 100 trials, each of which right code passes with probability 0.99^(1/100). At
/// most max(1, 1 %) of them may fail. Consecutive parts of the draws of a channel are the trials.
/// Source   absl/random/gaussian_distribution_test.cc, ZTest; internal/distribution_test_util.cc
bool fails_by_abseil(const JudgedDraws& draws, std::size_t trials = 100);

/// The rule of a project for when a Monte Carlo test fails.
struct Judge {
  std::string name;
  bool (*fails)(const JudgedDraws& draws);
};

const std::vector<Judge>& judges();

}  // namespace fairlight
