#pragma once

#include <fairlight/validation/audit/test_kinds.h>

namespace fairlight {

/// Tests of laws: on cells, of outcomes, by moments, and against another sampler. The bias is the
/// relative L2 distance of the draws' law.
const std::vector<TestKind>& law_kinds();

}  // namespace fairlight
