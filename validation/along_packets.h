#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fairlight/estimators/sobol.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks.h>

namespace fairlight {

namespace detail {

/// Throws BadDraw where a draw is out of the range that its reference declares.
inline void require_in_range(std::uint64_t draw, double value, const Reference& reference) {
  if (!std::isfinite(value)) throw BadDraw(draw, value, "in double, not a finite number");
  if (value < reference.lower) throw BadDraw(draw, value, "in double, below its declared lower bound");
  if (value > reference.upper && reference.tail_slack == 0)
    throw BadDraw(draw, value, "in double, above its declared upper bound");
}

}  // namespace detail

/// What draws in double, of these references, have more than those in packets, lane by lane from the same numbers:
/// `draw(type_identity<Real>, source)`. Where there is a tail, what is above the bound does not count. Throws BadDraw for a draw in
/// double that is out of its range.
template <class Draw>
DrawBlock less_packets(const StreamKey& key, const std::vector<Reference>& references, const Draw& draw) {
  return draws_at_once<Packet>(references.size(), [key, references, draw](std::uint64_t first, const auto& places) {
    Recording recording(key, first);
    StreamNumbers<Packet> numbers(recording);
    const auto floats = draw(std::type_identity<Packet>{}, numbers);
    for (std::size_t c = 0; c < places.size(); ++c) store_lanes(detail::channel_of(floats, c), places[c]);
    for (std::size_t i = 0; i < lanes<Packet>; ++i) {
      StreamNumbers<double> finer_numbers(key, recording, i);
      const auto doubles = draw(std::type_identity<double>{}, finer_numbers);
      for (std::size_t c = 0; c < places.size(); ++c) {
        const double in_double = detail::channel_of(doubles, c);
        detail::require_in_range(first + i, in_double, references[c]);
        const double most = references[c].tail_slack > 0 ? references[c].upper : infinity<double>;
        places[c][i] = std::min(in_double, most) - std::min(places[c][i], most);
      }
    }
  });
}

namespace detail {

/// The shares of the margin: of the mean in packets, and of the difference. What the latter has of a margin of 1e-4 is four times the
/// rounding of floats, the least that a test by betting takes. A thousandth is left for tails.
inline constexpr double share_of_packets = 0.79, share_of_difference = 0.209;

/// The most that a tail may hide of a margin: the thousandth, at a margin 45 times as fine, which is the finest that a run leaves evidence for.
inline constexpr double most_in_tail = 2e-5;

/// References to which the trial's margin is a share of what it was, and a bias so much more.
inline std::vector<Reference> with_share(std::vector<Reference> references, double share) {
  for (Reference& r : references) {
    r.scale *= share;
    r.rounding /= share;
  }
  return references;
}

/// Of the difference of a draw in double from one in packets, where both have these references.
inline std::vector<Reference> of_difference(const std::vector<Reference>& references) {
  const std::vector<Reference> packets = rounded_references<Packet>(references);
  std::vector<Reference> differences;
  for (std::size_t c = 0; c < references.size(); ++c) {
    const Reference &r = references[c], &p = packets[c];
    differences.push_back({.mean = 0,
                           .lower = r.lower - p.upper,
                           .upper = r.upper - p.lower,
                           .scale = r.scale,
                           .rounding = arithmetic_rounding<Packet> + r.tail_slack / r.scale});
  }
  return with_share(differences, share_of_difference);
}

inline double log_of_mean(double log_a, double log_b) {
  const double top = std::max(log_a, log_b);
  return std::isinf(top) ? top : top + std::log((std::exp(log_a - top) + std::exp(log_b - top)) / 2);
}

/// What two parts say of the whole. A whole that is off by its margin has a part that is off by its share, so the less wealth of
/// the two is held against that; both parts are right where the whole is claimed to be, so the mean is held against the claim.
inline Wealth joint(const Wealth& a, const Wealth& b) {
  return {log_of_mean(a.too_bright, b.too_bright), log_of_mean(a.too_dark, b.too_dark),
          std::min(a.not_brighter, b.not_brighter), std::min(a.not_darker, b.not_darker)};
}

inline Ladder joint(Ladder a, const Ladder& b) {
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    for (std::size_t r = 0; r < a.channels[c].size(); ++r) {
      a.channels[c][r] = joint(a.channels[c][r], b.channels.empty() ? Wealth{} : b.channels[c][r]);
    }
  }
  return a;
}

/// Which part it is that has no certificate, and what is noted there.
inline std::string note_on(const std::string& part, const std::string& note) {
  return note.empty() ? part : formatted("%s: %s", part.c_str(), note.c_str());
}

/// What two parts found of a channel, of the whole.
inline Finding sum_of(const Trial& trial, const Finding& packets, const Finding& difference) {
  const double p = share_of_packets, d = share_of_difference;
  Finding sum = packets;
  sum.verdict = worse(packets.verdict, difference.verdict);
  sum.margin = trial.margin;
  sum.bias = p * packets.bias + d * difference.bias;
  sum.interval = {p * packets.interval.lo + d * difference.interval.lo,
                  p * packets.interval.hi + d * difference.interval.hi};
  sum.draws += difference.draws;
  sum.rounding = p * packets.rounding + d * difference.rounding;
  if (difference.verdict != Verdict::certified)
    sum.note = note_on("less its draws in packets of floats", difference.note);
  return sum;
}

}  // namespace detail

/// What packets draw with that a mean in double is seen along.
enum class PacketNumbers { independent, points };

/// The mean of `draw(type_identity<Real>, source)` in double, most of it seen in packets: E[double] = E[packet] + E[double - packet].
/// Packets draw some ten times as fast, and along the same numbers the difference is next to nothing, so that few draws show its
/// mean. That of packets does not depend on how their numbers are spread, so it may be seen over replicates of Sobol's points, which
/// vary less. Both parts must be certified, each to a share of the margin, and each has half of alpha.
/// Source   Hammersley and Handscomb 1964, 5.5 (the control variate); Owen 1995 (the points)
template <class Draw>
class AlongPackets {
 public:
  AlongPackets(const Trial& trial, const std::vector<Reference>& references, const Draw& draw)
      : trial_(trial),
        draw_(draw),
        references_(references),
        points_(points_for(references)),
        packets_(detail::with_share(replicate_references(rounded_references<Packet>(references), points_),
                                    detail::share_of_packets)),
        differences_(detail::of_difference(references)) {}

  /// By which numbers it takes less time than double alone, as pilots foresee, if by any: not where the range is so wide that it alone
  /// says how many draws there must be. A packet is taken to cost what a draw in double does, and twice as much where it has
  /// points. A pilot that is out of its range is left to double.
  std::optional<PacketNumbers> pays() const try {
    if (!fits()) return std::nullopt;
    const auto draws = pilot(1024, packet_draws(PacketNumbers::independent, " pilot"));
    const double alone = expected_draws(trial_, rounded_references<Packet>(references_), draws);
    const double independent = expected_draws(trial_, packets_, draws) / lanes<Packet>;
    const double points =
        expected_draws(trial_, packets_, pilot(64, packet_draws(PacketNumbers::points, " pilot"))) * 2 * points_ /
        lanes<Packet>;
    const double in_packets = std::min(independent, points);
    if (in_packets > alone) return std::nullopt;
    const auto differences = pilot(512, difference_draws(" pilot"));
    const double of_differences = (1 + 1.0 / lanes<Packet>)*expected_draws(trial_, differences_, differences);
    if (in_packets + of_differences > alone) return std::nullopt;
    return points < independent ? PacketNumbers::points : PacketNumbers::independent;
  } catch (const BadDraw&) {
    return std::nullopt;
  }

  /// Where the packets fail, the figures are theirs, as the difference is then not drawn, and the note says so. Throws what test_means
  /// does.
  Finding finding(PacketNumbers numbers) const {
    Evidence of_packets, of_difference;
    std::vector<Finding> packets = test_each_mean(part(0, of_packets), packets_, packet_draws(numbers, ""));
    if (numbers == PacketNumbers::points) {
      for (Finding& each : packets) each.draws *= points_;
    }
    const bool go_on = worst_of(packets).verdict == Verdict::certified;
    std::vector<Finding> differences(packets.size(), Finding{.verdict = Verdict::certified});
    if (go_on) differences = test_each_mean(part(1, of_difference), differences_, difference_draws(""));
    leave(of_packets, of_difference);
    std::vector<Finding> sums;
    for (std::size_t c = 0; c < packets.size(); ++c) {
      sums.push_back(detail::sum_of(trial_, packets[c], differences[c]));
    }
    Finding whole = worst_of(sums);
    const char* seen = numbers == PacketNumbers::points
                           ? "seen in packets of floats over Sobol' points, which it is drawn along"
                           : "seen in packets of floats, which it is drawn along";
    if (!go_on) whole.note = detail::note_on(seen, whole.note);
    return whole;
  }

 private:
  // Whether both parts can be tested to their shares of the margin.
  bool fits() const {
    for (std::size_t c = 0; c < references_.size(); ++c) {
      const Reference& r = references_[c];
      const double rounding = std::max(packets_[c].rounding, differences_[c].rounding);
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

  std::vector<std::vector<double>> pilot(std::size_t draws, const DrawBlock& draw_block) const {
    std::vector channels(references_.size(), std::vector<double>(draws));
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
  std::vector<Reference> packets_, differences_;
};

/// The mean of an estimator in double: along its draws in packets where that is faster, and nobody listens, who is to hear draws in
/// double.
template <class Draw>
Finding check_mean_in_double(const Trial& trial, const std::vector<Reference>& references, const Draw& draw) {
  const bool heard = trial.evidence != nullptr && trial.evidence->listener;
  if (!heard) {
    const AlongPackets<Draw> along(trial, references, draw);
    if (const auto numbers = along.pays()) return along.finding(*numbers);
  }
  return check_mean<double>(trial, references,
                            [&](auto& source) { return draw(std::type_identity<double>{}, source); });
}

}  // namespace fairlight
