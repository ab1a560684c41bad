#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fairlight/estimators/stream.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/parameters.h>

namespace fairlight {
namespace {

double value_at(const ParameterRange& range, double u) {
  if (range.law == ParameterRange::Law::logarithmic)
    return std::clamp(range.low * std::pow(range.high / range.low, u), range.low, range.high);
  return range.low + u * (range.high - range.low);
}

}  // namespace

void check_ranges(const std::string& claim, const std::vector<ParameterRange>& ranges) {
  for (const ParameterRange& range : ranges) {
    const auto domain = std::ranges::find_if(parameter_domains(), [&](const ParameterDomain& d) {
      return d.component == range.component && d.parameter == range.parameter;
    });
    if (domain == parameter_domains().end())
      throw std::logic_error(
          formatted("\"%s\" draws the %s of %s, which has no domain (add it to checks/domains.cpp)", claim.c_str(),
                    range.parameter.c_str(), range.component.c_str()));
    const bool inside = domain->low <= range.low && range.low <= range.high && range.high <= domain->high;
    const bool has_law = range.law == ParameterRange::Law::uniform || range.low > 0;
    if (!inside || !has_law)
      throw std::logic_error(
          formatted("\"%s\" draws the %s of %s from [%g, %g], which is not within its domain "
                    "[%g, %g], or not positive as a logarithmic range must be",
                    claim.c_str(), range.parameter.c_str(), range.component.c_str(), range.low, range.high,
                    domain->low, domain->high));
  }
}

std::vector<double> middles(const std::vector<ParameterRange>& ranges) {
  std::vector<double> values;
  for (const ParameterRange& range : ranges) values.push_back(value_at(range, 0.5));
  return values;
}

std::vector<double> drawn(const std::vector<ParameterRange>& ranges, const Trial& trial) {
  PhiloxStream<double> numbers(StreamKey(trial.seed, trial.claim + " parameters"), 0, 0);
  std::vector<double> values;
  for (const ParameterRange& range : ranges) values.push_back(value_at(range, numbers.next()));
  return values;
}

Finding with_parameters(Finding finding, const std::vector<ParameterRange>& ranges,
                        const std::vector<double>& values) {
  if (finding.verdict == Verdict::certified) return finding;
  constexpr std::size_t most = 12;  // what a reader takes in; a replay draws the same ones
  std::string list;
  for (std::size_t i = 0; i < std::min(ranges.size(), most); ++i)
    list += formatted("%s%s = %.9g", i == 0 ? "" : ", ", ranges[i].parameter.c_str(), values[i]);
  if (ranges.size() > most) list += formatted(" and %zu more numbers", ranges.size() - most);
  finding.note += formatted("%sat %s", finding.note.empty() ? "" : "; ", list.c_str());
  return finding;
}

}  // namespace fairlight
