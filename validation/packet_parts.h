#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fairlight/stats/evidence.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks.h>

/// The two parts of a mean in double, that of draws in packets and that of what draws in double have more; and what they say together.
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

/// What the difference has of the margin where the mean in packets has this share. A thousandth is left for tails.
inline double share_of_difference(double share_of_packets) { return 0.999 - share_of_packets; }

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

/// Of the difference of a draw in double from one in packets, where both have these references, and the packets' mean this share.
inline std::vector<Reference> of_difference(const std::vector<Reference>& references, double share_of_packets) {
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
  return with_share(differences, share_of_difference(share_of_packets));
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

/// What two parts found of a channel, of the whole. The packets had the share p.
inline Finding sum_of(const Trial& trial, const Finding& packets, const Finding& difference, double p) {
  const double d = share_of_difference(p);
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

}  // namespace fairlight
