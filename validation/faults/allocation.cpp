#include <fairlight/estimators/allocation_unbiased.h>
#include <fairlight/validation/claims/spiky_pixels.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_allocation.h>

namespace fairlight {
namespace {

constexpr AllocationPlan plan{PixelGrid(4, 2), 64, 2};
constexpr const char* source = "Kirk and Arvo 1991";

/// The rows of a form, for each score that divides its budget.
template <template <class> class Form, class... Stages>
std::vector<Claim> rows(const std::string& form, Stages... stages) {
  return {unbiased_allocation("allocation." + form + ".deviation", {}, source,
                              Form<AllocationByDeviation>(plan, stages...)),
          unbiased_allocation("allocation." + form + ".variance", {}, source,
                              Form<AllocationByVariance>(plan, stages...))};
}

Claim row_from_one_set() {
  return unbiased_allocation("allocation.stages.variance", {}, source,
                             FixedStageWeights<AllocationByVariance>(plan, 3), faults::FromOneSet());
}

}  // namespace

std::vector<Fault> allocation_faults() {
  return {
      {"pilot-kept", "adaptive reuse", source, rows<naive::PooledStages>("pilot")},
      {"stages-weighed-by-counts", "adaptive reuse", source, rows<faults::StagesWeighedByCounts>("stages", 3u)},
      {"halves-sizing-themselves", "adaptive reuse", source, rows<faults::HalvesSizingThemselves>("halves")},
      {"halves-weighed-by-counts", "adaptive reuse", source, rows<faults::HalvesWeighedByCounts>("halves")},
      {"sobol-continued-over-stages", "adaptive reuse", "the class of Kirk and Arvo 1991", {row_from_one_set()}}};
}

}  // namespace fairlight
