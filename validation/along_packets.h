#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fairlight/estimators/sobol.h>
#include <fairlight/validation/packet_parts.h>

namespace fairlight {

/// What packets draw with that a mean in double is seen along.
enum class PacketNumbers { independent, points };

/// That, and the packets' share of the margin. What the largest share leaves of a margin of 1e-4 is four times the rounding of floats,
/// the least that a test by betting takes; where the difference is dear, as paths in floats part from those in double, it is given more.
struct PacketPlan {
  static constexpr std::array shares{0.79, 0.6, 0.4};

  PacketNumbers numbers = PacketNumbers::independent;
  double share = shares.front();
};

/// The mean of `draw(type_identity<Real>, source)` in double, most of it seen in packets: E[double] = E[packet] + E[double - packet].
/// Packets draw some ten times as fast, and along the same numbers the difference is next to nothing, so that few draws show its
/// mean. That of packets does not depend on how their numbers are spread, so it may be seen over replicates of Sobol's points, which
/// vary less. Both parts must be certified, each to a share of the margin, and each has half of alpha.
/// Source   Hammersley and Handscomb 1964, 5.5 (the control variate); Owen 1995 (the points)
template <class Draw>
class AlongPackets {
 public:
  AlongPackets(const Trial& trial, const std::vector<Reference>& references, const Draw& draw)
      : trial_(trial), draw_(draw), references_(references), points_(points_for(references)) {}

  /// How it takes the least time, and less than double alone, as pilots foresee, if at all: not where the range is so wide that it alone
  /// says how many draws there must be. A packet is taken to cost what a draw in double does, and twice as much where it has
  /// points. A pilot that is out of its range is left to double.
  std::optional<PacketPlan> pays() const try {
    if (std::ranges::none_of(PacketPlan::shares, [this](double share) { return fits(share); })) return std::nullopt;
    const Channels independent = pilot(1024, packet_draws(PacketNumbers::independent, " pilot"));
    const Channels points = pilot(64, packet_draws(PacketNumbers::points, " pilot"));
    double least = expected_draws(trial_, rounded_references<Packet>(references_), independent);
    if (in_packets(PacketPlan::shares.front(), independent, points).cost > least) return std::nullopt;
    const double pilot_size = std::clamp(least / 1000, 512.0, 16384.0);  // rare differences may say most
    const Channels differences = pilot(static_cast<std::size_t>(pilot_size), difference_draws(" pilot"));
    std::optional<PacketPlan> plan;
    for (const double share : PacketPlan::shares) {
      if (!fits(share)) continue;
      const auto [numbers, cost] = in_packets(share, independent, points);
      const double whole =
          cost + (1 + 1.0 / lanes<Packet>)*expected_draws(trial_, difference_references(share), differences);
      if (whole > least) continue;
      least = whole;
      plan = PacketPlan{numbers, share};
    }
    return plan;
  } catch (const BadDraw&) {
    return std::nullopt;
  }

  /// Where the packets fail, the figures are theirs, as the difference is then not drawn, and the note says so. Throws what test_means
  /// does.
  Finding finding(const PacketPlan& plan) const {
    const bool over_points = plan.numbers == PacketNumbers::points;
    Evidence of_packets, of_difference;
    std::vector<Finding> packets =
        test_each_mean(part(0, of_packets), packet_references(plan.share), packet_draws(plan.numbers, ""));
    if (over_points) {
      for (Finding& each : packets) each.draws *= points_;
    }
    const bool go_on = worst_of(packets).verdict == Verdict::certified;
    std::vector<Finding> differences(packets.size(), Finding{.verdict = Verdict::certified});
    if (go_on)
      differences = test_each_mean(part(1, of_difference), difference_references(plan.share), difference_draws(""));
    leave(of_packets, of_difference);
    std::vector<Finding> sums;
    for (std::size_t c = 0; c < packets.size(); ++c) {
      sums.push_back(detail::sum_of(trial_, packets[c], differences[c], plan.share));
    }
    Finding whole = worst_of(sums);
    const char* seen = over_points ? "seen in packets of floats over Sobol' points, which it is drawn along"
                                   : "seen in packets of floats, which it is drawn along";
    if (!go_on) whole.note = detail::note_on(seen, whole.note);
    return whole;
  }

 private:
  using Channels = std::vector<std::vector<double>>;

  std::vector<Reference> packet_references(double share) const {
    return detail::with_share(replicate_references(rounded_references<Packet>(references_), points_), share);
  }
  std::vector<Reference> difference_references(double share) const {
    return detail::of_difference(references_, share);
  }

  struct Choice {
    PacketNumbers numbers;
    double cost;  ///< in draws in double
  };

  // With which numbers the packets' mean takes less time.
  Choice in_packets(double share, const Channels& independent, const Channels& points) const {
    const std::vector<Reference> references = packet_references(share);
    const double one_by_one = expected_draws(trial_, references, independent) / lanes<Packet>;
    const double in_sets = expected_draws(trial_, references, points) * 2 * points_ / lanes<Packet>;
    return in_sets < one_by_one ? Choice{PacketNumbers::points, in_sets}
                                : Choice{PacketNumbers::independent, one_by_one};
  }

  // Whether both parts can be tested to their shares of the margin.
  bool fits(double share) const {
    const std::vector<Reference> packets = packet_references(share), differences = difference_references(share);
    for (std::size_t c = 0; c < references_.size(); ++c) {
      const Reference& r = references_[c];
      const double rounding = std::max(packets[c].rounding, differences[c].rounding);
      if (r.sides != Sides::both || r.tail_slack > detail::most_in_tail * trial_.margin * r.scale ||
          rounding > trial_.margin / 4)
        return false;
    }
    return true;
  }

  // The trial of the first part, or the second.
  Trial part(int i, Evidence& evidence) const {
    Trial part = trial_;
    part.alpha /= 2;
    part.evidence = trial_.evidence == nullptr ? nullptr : &evidence;
    if (trial_.watch) part.watch = [this, i](double done) { return goes_on(trial_, (i + done) / 2); };
    return part;
  }

  Channels pilot(std::size_t draws, const DrawBlock& draw_block) const {
    Channels channels(references_.size(), std::vector<double>(draws));
    draw_block(0, channels);
    return channels;
  }

  // What a tail may hide of draws it may hide of their means, at most (Jensen).
  DrawBlock packet_draws(PacketNumbers numbers, const std::string& purpose) const {
    const auto in_packets = [draw = draw_](auto& source) { return draw(std::type_identity<Packet>{}, source); };
    if (numbers == PacketNumbers::independent)
      return independent_draws<Packet>(StreamKey(trial_.seed, trial_.claim + purpose), references_.size(),
                                       in_packets);
    const StreamKey key(trial_.seed, trial_.claim + " over points" + purpose);
    return replicate_draws<OwenSobol<Packet>>(key, in_packets, points_);
  }

  DrawBlock difference_draws(const std::string& purpose) const {
    return less_packets(StreamKey(trial_.seed, trial_.claim + " in double" + purpose), references_, draw_);
  }

  void leave(const Evidence& packets, const Evidence& difference) const {
    if (trial_.evidence == nullptr) return;
    trial_.evidence->ladder = detail::joint(packets.ladder, difference.ladder);
    for (const Evidence* each : {&packets, &difference}) {
      trial_.evidence->means.insert(trial_.evidence->means.end(), each->means.begin(), each->means.end());
    }
  }

  Trial trial_;
  Draw draw_;
  std::vector<Reference> references_;
  std::uint32_t points_;  ///< of a replicate
};

/// The mean of an estimator in double: along its draws in packets where that is faster, and nobody listens, who is to hear draws in
/// double.
template <class Draw>
Finding check_mean_in_double(const Trial& trial, const std::vector<Reference>& references, const Draw& draw) {
  const bool heard = trial.evidence != nullptr && trial.evidence->listener;
  if (!heard) {
    const AlongPackets<Draw> along(trial, references, draw);
    if (const auto plan = along.pays()) return along.finding(*plan);
  }
  return check_mean<double>(trial, references,
                            [&](auto& source) { return draw(std::type_identity<double>{}, source); });
}

}  // namespace fairlight
