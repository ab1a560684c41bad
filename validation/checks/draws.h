#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <fairlight/stats/mean_test.h>
#include <fairlight/validation/checks/numbers.h>

/// Estimators as checks see them: what draws is compiled once for an arithmetic and an instruction set;
/// what tests, schedules and reports knows no component's type.
namespace fairlight {

/// What the arithmetic of a Real may add to a mean or take from it, relative: nothing that shows in double. In
/// floats, 84 roundings of half an ulp, 2^-24, that all go one way: more than any component makes.
template <class Real>
inline constexpr double arithmetic_rounding = lanes<Real> > 1 ? 5e-6 : 0;

/// References as an arithmetic of that rounding can keep them: the range widened, and the mean allowed to be off.
std::vector<Reference> rounded_references(std::vector<Reference> references, double rounding);

template <class Real>
std::vector<Reference> rounded_references(std::vector<Reference> references) {
  return rounded_references(std::move(references), arithmetic_rounding<Real>);
}

/// References of the means of replicates of n points: the range is that of the estimator, but for the n roundings of
/// the sum in double. What lanes round before, rounded_references leaves room for.
std::vector<Reference> replicate_references(std::vector<Reference> references, std::uint32_t n);

/// Draws that are made `lanes` at a time: `make(first, places)` puts channel c of draw first + i at places[c][i]. Lanes
/// are kept and handed out one at a time where a test asks for single draws, as it does where the range is wide.
using MakePacket = std::function<void(std::uint64_t first, std::span<double* const> places)>;
DrawBlock draws_at_once(std::size_t lanes, std::size_t channel_count, MakePacket make);

namespace detail {

/// One channel of a draw: the number itself, or a colour's.
template <class Value>
auto channel_of(const Value& x, std::size_t c) {
  if constexpr (requires { x.rows(); }) {
    return x[static_cast<Eigen::Index>(c)];
  } else {
    return x;
  }
}

/// A point of the lane, in double: a number or a vector.
template <class Point>
auto lane_of(const Point& x, std::size_t lane) {
  const auto number = [lane](const auto& value) {
    std::array<double, lanes<std::remove_cvref_t<decltype(value)>>> values{};
    store_lanes(value, values.data());
    return values[lane];
  };
  if constexpr (requires { x.rows(); }) {
    Eigen::Matrix<double, Point::RowsAtCompileTime, 1> point;
    for (Eigen::Index i = 0; i < point.size(); ++i) point[i] = number(x[i]);
    return point;
  } else {
    return number(x);
  }
}

}  // namespace detail

/// An estimator in one arithmetic.
template <class Real>
class Body {
 public:
  virtual ~Body() = default;
  /// One draw (of a packet, one a lane): the first channels of it.
  virtual void draw(NumberSource<Real>& numbers, std::span<Real> channels) const = 0;
};

namespace detail {

template <class Real, class Draw>
class BodyOf final : public Body<Real> {
 public:
  explicit BodyOf(const Draw& draw) : draw_(draw) {}
  void draw(NumberSource<Real>& numbers, std::span<Real> channels) const override {
    const auto x = draw_(std::type_identity<Real>{}, numbers);
    for (std::size_t c = 0; c < channels.size(); ++c) channels[c] = channel_of(x, c);
  }

 private:
  Draw draw_;
};

}  // namespace detail

/// That of `draw(type_identity<Real>, source)`, which gives a Real or an Rgb<Real>.
template <class Real, class Draw>
std::shared_ptr<const Body<Real>> body_of(const Draw& draw) {
  return std::make_shared<const detail::BodyOf<Real, Draw>>(draw);
}

/// That of `draw(source)`.
template <class Real, class Draw>
std::shared_ptr<const Body<Real>> body_of_source(const Draw& draw) {
  return body_of<Real>([draw](std::type_identity<Real>, auto& source) { return Real(draw(source)); });
}

/// The draws of an estimator in one arithmetic, whatever that is.
struct Draws {
  std::size_t lanes;
  double rounding;  ///< of the arithmetic
  /// From independent numbers.
  std::function<DrawBlock(const StreamKey& key)> independent;
  /// The means of replicates of n Sobol' points. Throws BadDraw for a point that its reference rules out.
  std::function<DrawBlock(const StreamKey& key, const std::vector<Reference>& references, std::uint32_t n)>
      replicates;
};

/// The same estimator in double and in packets.
struct PairedDraws {
  Draws in_double, in_packets;
  /// What draws in double, of these references, have more than those in packets, lane by lane from the same numbers.
  /// Where there is a tail, what is above the bound does not count. Throws BadDraw for a draw in double out of its range.
  std::function<DrawBlock(const StreamKey& key, const std::vector<Reference>& references)> double_minus_packet;
  /// How many draws in double take as long as a packet, by the numbers that each takes: where the lanes of a packet wait
  /// for the longest, it takes more of them.
  std::function<double(const StreamKey& key)> draws_a_packet;
};

/// They are compiled once for each instruction set, in draws.cpp. `channels` is how many of them are looked at.
template <class Real>
Draws draws_of(std::shared_ptr<const Body<Real>> body, std::size_t channels);

template <class Packets>
PairedDraws paired_draws(std::shared_ptr<const Body<double>> in_double,
                         std::shared_ptr<const Body<Packets>> in_packets, std::size_t channels);

/// The means of replicates of n points as draws, from a set's numbers. A replicate must fill whole packets (else
/// std::invalid_argument). Throws BadDraw for a point that its reference rules out, which the mean may hide.
template <class Real>
DrawBlock replicate_draws(std::shared_ptr<PointNumbers<Real>> numbers, std::shared_ptr<const Body<Real>> body,
                          const StreamKey& key, const std::vector<Reference>& references, std::uint32_t n);

extern template Draws draws_of(std::shared_ptr<const Body<double>>, std::size_t);
extern template Draws draws_of(std::shared_ptr<const Body<Packet>>, std::size_t);
extern template PairedDraws paired_draws(std::shared_ptr<const Body<double>>, std::shared_ptr<const Body<Packet>>,
                                         std::size_t);
extern template DrawBlock replicate_draws(std::shared_ptr<PointNumbers<double>>,
                                          std::shared_ptr<const Body<double>>, const StreamKey&,
                                          const std::vector<Reference>&, std::uint32_t);
extern template DrawBlock replicate_draws(std::shared_ptr<PointNumbers<Packet>>,
                                          std::shared_ptr<const Body<Packet>>, const StreamKey&,
                                          const std::vector<Reference>&, std::uint32_t);

}  // namespace fairlight
