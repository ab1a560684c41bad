#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fairlight/validation/packet_mean.h>

namespace fairlight {

/// How the numbers of packets are spread, and their share of the margin. What the largest share leaves of a margin of 1e-4 is four times the
/// rounding of floats, the least that a test by betting takes; where the difference is dear, as paths in floats part from those in double,
/// it is given more.
struct PacketPlan {
  static constexpr std::array shares{0.79, 0.6, 0.4};

  Spread spread;
  double share = shares.front();
};

/// The mean of `draw(type_identity<Real>, source)` in double, most of it seen in packets: E[double] = E[packet] + E[double - packet].
/// Packets draw some ten times as fast, and along the same numbers the difference is next to nothing, so that few draws show its
/// mean. Both parts must be certified, each to a share of the margin, and each has half of alpha.
/// Source   Hammersley and Handscomb 1964, 5.5 (the control variate)
template <class Draw>
class AlongPackets {
 public:
  AlongPackets(const Trial& trial, const std::vector<Reference>& references, const Draw& draw)
      : trial_(trial), draw_(draw), references_(references), packets_(trial, references, draw) {}

  /// How it takes the least time, and less than double alone, as pilots foresee, if at all: not where the range is so wide that it alone
  /// says how many draws there must be, nor where these are so few that pilots cost more than they save. A pilot that is
  /// out of its range is left to double.
  std::optional<PacketPlan> pays() const try {
    if (std::ranges::none_of(PacketPlan::shares, [this](double share) { return fits(share); })) return std::nullopt;
    auto pilots = packets_.pilots();
    double least = lanes<Packet> * pilots.one_by_one(1).cost;
    if (least < few) return std::nullopt;
    pilots.add_rows();
    pilots.add_sets();
    const double packet = draws_a_packet();
    if (packet * pilots.cheapest(PacketPlan::shares.front()).cost > least) return std::nullopt;
    const double pilot_size = std::clamp(least / 1000, 512.0, 16384.0);  // rare differences may say most
    std::vector differences(references_.size(), std::vector<double>(static_cast<std::size_t>(pilot_size)));
    difference_draws(" pilot")(0, differences);
    std::optional<PacketPlan> plan;
    for (const double share : PacketPlan::shares) {
      if (!fits(share)) continue;
      const auto [spread, cost] = pilots.cheapest(share);
      const double whole = packet * cost + (1 + packet / lanes<Packet>)*expected_draws(
                                               trial_, difference_references(share), differences);
      if (whole > least) continue;
      least = whole;
      plan = PacketPlan{spread, share};
    }
    return plan;
  } catch (const BadDraw&) {
    return std::nullopt;
  }

  /// Where the packets fail, the figures are theirs, as the difference is then not drawn, and the note says so. Throws what test_means
  /// does.
  Finding finding(const PacketPlan& plan) const {
    Evidence of_packets, of_difference;
    const std::vector<Finding> packets = packets_.test_each(part(0, of_packets), plan.spread, plan.share);
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
    const char* seen = plan.spread.over_points
                           ? "seen in packets of floats over Sobol' points, which it is drawn along"
                           : "seen in packets of floats, which it is drawn along";
    if (!go_on) whole.note = detail::note_on(seen, whole.note);
    return whole;
  }

 private:
  std::vector<Reference> difference_references(double share) const {
    return detail::of_difference(references_, share);
  }

  // Whether both parts can be tested to their shares of the margin.
  bool fits(double share) const {
    const std::vector<Reference> packets = packets_.references({}, share),
                                 differences = difference_references(share);
    for (std::size_t c = 0; c < references_.size(); ++c) {
      const Reference& r = references_[c];
      const double rounding = std::max(packets[c].rounding, differences[c].rounding);
      if (r.sides != Sides::both || r.tail_slack > detail::most_in_tail * trial_.margin * r.scale ||
          rounding > trial_.margin / 4)
        return false;
    }
    return true;
  }

  static constexpr double few = 16384;  // ten times what pilots cost

  // How many draws in double take as long as a packet, by the numbers that each takes: where the lanes of a packet wait for the longest, it takes
  // more of them.
  double draws_a_packet() const {
    const StreamKey key(trial_.seed, trial_.claim + " in double length");
    std::size_t by_packets = 0, by_lanes = 0;
    for (std::uint64_t first = 0; first < 32 * lanes<Packet>; first += lanes<Packet>) {
      Recording recording(key, first);
      StreamNumbers<Packet> numbers(recording);
      draw_(std::type_identity<Packet>{}, numbers);
      by_packets += lanes<Packet> * numbers.drawn();
      for (std::size_t i = 0; i < lanes<Packet>; ++i) {
        StreamNumbers<double> finer(key, recording, i);
        draw_(std::type_identity<double>{}, finer);
        by_lanes += finer.drawn();
      }
    }
    return by_lanes > 0 ? static_cast<double>(by_packets) / static_cast<double>(by_lanes) : 1;
  }

  // The trial of the first part, or the second.
  Trial part(int i, Evidence& evidence) const {
    Trial part = trial_;
    part.alpha /= 2;
    part.evidence = trial_.evidence == nullptr ? nullptr : &evidence;
    if (trial_.watch) part.watch = [this, i](double done) { return goes_on(trial_, (i + done) / 2); };
    return part;
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
  PacketMean<Draw> packets_;
};

/// The mean of an estimator in double: along its draws in packets where that is faster, and nobody listens, who is to hear draws in
/// double.
template <class Draw>
Finding check_mean_in_double(const Trial& trial, const std::vector<Reference>& references, const Draw& draw) {
  if (!detail::is_heard(trial)) {
    const AlongPackets<Draw> along(trial, references, draw);
    if (const auto plan = along.pays()) return along.finding(*plan);
  }
  return check_mean<double>(trial, references,
                            [&](auto& source) { return draw(std::type_identity<double>{}, source); });
}

}  // namespace fairlight
