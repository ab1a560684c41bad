#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fairlight/stats/common_bias.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/means.h>

namespace fairlight {
namespace {

constexpr double few = 16384;  // draws in double: ten times the cost of the pilots

// The largest part of a margin that a tail slack may be. share_of_difference leaves 1e-3 of the
// margin for it, and a run keeps evidence for margins down to a 45th of its own.
constexpr double most_in_tail = 2e-5;

// The difference's share of the margin, from the packets' share. It leaves 1e-3 of the margin for
// tails.
double share_of_difference(double share_of_packets) { return 0.999 - share_of_packets; }

// The references of the difference of a draw in double and one in packets, from the references of
// both. Rescales them to the share of the margin that the packets leave.
std::vector<Reference> of_difference(const std::vector<Reference>& references, double rounding,
                                     double share_of_packets) {
  const std::vector<Reference> packets = rounded_references(references, rounding);
  const double share = share_of_difference(share_of_packets);
  std::vector<Reference> differences;
  for (std::size_t c = 0; c < references.size(); ++c) {
    const Reference &r = references[c], &p = packets[c];
    differences.push_back({.mean = 0,
                           .lower = r.lower - p.upper,
                           .upper = r.upper - p.lower,
                           .scale = r.scale * share,
                           .rounding = (rounding + r.tail_slack / r.scale) / share});
  }
  return differences;
}

double log_of_mean(double log_a, double log_b) { return log_mean_exp(std::array{log_a, log_b}); }

MarginGrid joint(MarginGrid a, const MarginGrid& b) {
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    for (std::size_t r = 0; r < a.channels[c].size(); ++r) {
      a.channels[c][r] = detail::joint(a.channels[c][r], b.channels.empty() ? Wealth{} : b.channels[c][r]);
    }
  }
  return a;
}

// Puts the name of the part that is not certified before its note.
std::string note_on(const std::string& part, const std::string& note) {
  return note.empty() ? part : part + ": " + note;
}

// The finding of the sum, for one channel. p is the share of the packets. If the difference is biased,
// the figures are its own: those of the sum may lie around 0.
Finding sum_of(const Trial& trial, const Finding& packets, const Finding& difference, double p) {
  const double d = share_of_difference(p);
  const double of_packets = difference.verdict == Verdict::biased ? 0 : p;
  Finding sum = packets;
  sum.verdict = worse(packets.verdict, difference.verdict);
  sum.margin = trial.margin;
  sum.bias = of_packets * packets.bias + d * difference.bias;
  sum.interval = {of_packets * packets.interval.lo + d * difference.interval.lo,
                  of_packets * packets.interval.hi + d * difference.interval.hi};
  sum.draws += difference.draws;
  sum.rounding = p * packets.rounding + d * difference.rounding;
  if (difference.verdict != Verdict::certified)
    sum.note = note_on("the difference between double and packets", difference.note);
  return sum;
}

// The finding of the packets alone, for one channel. Unless they are biased, nothing is known of the
// mean in double, as the difference was not drawn.
Finding without_difference(const Trial& trial, const Finding& packets, double p) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Finding alone = packets;
  alone.margin = trial.margin;
  alone.bias *= p;
  alone.interval = {p * packets.interval.lo, p * packets.interval.hi};
  alone.rounding *= p;
  if (packets.verdict != Verdict::biased) alone.interval = {-infinite, infinite};
  return alone;
}

}  // namespace

namespace detail {

Wealth joint(const Wealth& a, const Wealth& b) {
  return {log_of_mean(a.above_reference, b.above_reference), log_of_mean(a.below_reference, b.below_reference),
          std::min(a.below_upper_margin, b.below_upper_margin),
          std::min(a.above_lower_margin, b.above_lower_margin)};
}

}  // namespace detail

PacketControlVariate::PacketControlVariate(const Trial& trial, const std::vector<Reference>& references,
                                           const PairedDraws& draws)
    : trial_(trial), references_(references), draws_(draws), packets_(trial, references, draws.in_packets) {}

std::vector<Reference> PacketControlVariate::difference_references(double share) const {
  return of_difference(references_, draws_.in_packets.rounding, share);
}

// Whether both parts can be tested to their shares of the margin.
bool PacketControlVariate::fits(double share) const {
  const std::vector<Reference> packets = packets_.references({}, share), differences = difference_references(share);
  for (std::size_t c = 0; c < references_.size(); ++c) {
    const Reference& r = references_[c];
    const double rounding = std::max(packets[c].rounding, differences[c].rounding);
    if (r.sides != Sides::both || r.tail_slack > most_in_tail * trial_.margin * r.scale ||
        rounding > trial_.margin / 4)
      return false;
  }
  return true;
}

std::optional<PacketControlVariate::Plan> PacketControlVariate::pays() const {
  if (std::ranges::none_of(Plan::shares, [this](double share) { return fits(share); })) return std::nullopt;
  return cheapest_plan();
}

std::optional<PacketControlVariate::Plan> PacketControlVariate::cheapest_plan() const {
  const auto lanes = static_cast<double>(draws_.in_packets.lanes);
  auto pilots = packets_.pilots();
  double least = lanes * pilots.independent(1).cost;
  if (least < few) return std::nullopt;
  pilots.add_points();
  const double packet = draws_.draws_a_packet(StreamKey(trial_.seed, trial_.claim + " in double length"));
  if (packet * pilots.cheapest(Plan::shares.front()).cost > least) return std::nullopt;
  const double pilot_size = std::clamp(least / 1000, 512.0, 16384.0);  // large, as rare differences may matter most
  std::vector differences(references_.size(), std::vector<double>(static_cast<std::size_t>(pilot_size)));
  difference_draws(" pilot")(0, differences);
  std::optional<Plan> plan;
  for (const double share : Plan::shares) {
    if (!fits(share)) continue;
    const auto [scheme, cost] = pilots.cheapest(share);
    const double whole =
        packet * cost + (1 + packet / lanes) * expected_draws(trial_, difference_references(share), differences);
    if (whole > least) continue;
    least = whole;
    plan = Plan{scheme, share};
  }
  return plan;
}

Finding PacketControlVariate::finding(const Plan& plan) const {
  Evidence of_packets, of_difference;
  const std::vector<Finding> packets = packets_.test_each(part(0, of_packets), plan.scheme, plan.share);
  const bool go_on = worst_of(packets).verdict == Verdict::certified;
  std::vector<Finding> differences;
  if (go_on)
    differences = test_each_mean(part(1, of_difference), difference_references(plan.share), difference_draws(""));
  leave(of_packets, of_difference);
  std::vector<Finding> channels;
  for (std::size_t c = 0; c < packets.size(); ++c) {
    channels.push_back(go_on ? sum_of(trial_, packets[c], differences[c], plan.share)
                             : without_difference(trial_, packets[c], plan.share));
  }
  Finding whole = worst_of(channels);
  if (!go_on)
    whole.note = note_on(
        plan.scheme.is_independent() ? "tested in packets" : "tested in packets over Sobol' points", whole.note);
  return whole;
}

// The trial of part i, 0 or 1.
Trial PacketControlVariate::part(int i, Evidence& evidence) const {
  Trial part = trial_;
  part.alpha /= 2;
  part.evidence = trial_.evidence == nullptr ? nullptr : &evidence;
  evidence.courses = trial_.evidence != nullptr && trial_.evidence->courses;
  if (trial_.watch) part.watch = [this, i](double done) { return goes_on(trial_, (i + done) / 2); };
  return part;
}

DrawBlock PacketControlVariate::difference_draws(const std::string& purpose) const {
  return draws_.double_minus_packet(StreamKey(trial_.seed, trial_.claim + " in double" + purpose), references_);
}

void PacketControlVariate::leave(const Evidence& packets, const Evidence& difference) const {
  if (trial_.evidence == nullptr) return;
  trial_.evidence->margin_grid = joint(packets.margin_grid, difference.margin_grid);
  for (const Evidence* each : {&packets, &difference}) {
    trial_.evidence->means.insert(trial_.evidence->means.end(), each->means.begin(), each->means.end());
  }
}

}  // namespace fairlight
