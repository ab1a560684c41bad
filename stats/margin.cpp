#include <cmath>
#include <stdexcept>

#include <fairlight/stats/margin.h>
#include <fairlight/stats/text.h>

namespace fairlight {

Margin::Margin(double share, double scale) : share_(share), scale_(scale) {
  if (!(scale > 0 && std::isfinite(scale)))
    throw std::invalid_argument(formatted("the scale of a margin is %g (give a positive number)", scale));
}

double Margin::scale(double reference) const {
  if (scale_ != 0) return scale_;
  if (!(std::abs(reference) > 0 && std::isfinite(reference)))
    throw std::invalid_argument(
        formatted("a share of the reference, which is %g, is no margin (give one in the unit of the draws: "
                  "fairlight::absolute(0.01), or as a share of a scale: fairlight::Margin(0.01, scale))",
                  reference));
  return std::abs(reference);
}

std::string Margin::unit_name(double scale) const {
  if (absolute_) return "in the unit of the draws";
  return scale_ == 0 ? "all relative" : formatted("relative to %g", scale);
}

Margin absolute(double margin) {
  if (!(margin > 0 && std::isfinite(margin)))
    throw std::invalid_argument(formatted("an absolute margin is %g (give a positive number)", margin));
  // The tests know margins as shares of a scale: here half of one twice as large.
  Margin result(0.5, 2 * margin);
  result.absolute_ = true;
  return result;
}

}  // namespace fairlight
