#pragma once

#include <fairlight/stats/common_bias.h>
#include <fairlight/validation/audit/test_kinds.h>

namespace fairlight {

/// Tests that add evidence up: over runs of one claim, and over the claims of one component.
const std::vector<TestKind>& joint_kinds();

/// The claims of a component, each off by `bias` and tested to `margin`: a third are of uniform
/// draws, a third of coins of probability 1/8, and a third of three channels that share their draws.
/// `failed` counts the claims that are biased.
struct SimulatedComponent {
  CommonBias common;
  int failed = 0;
};
SimulatedComponent simulate_component(const Trial& trial, int claims, double margin, double bias);

}  // namespace fairlight
