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

/// Estimators as checks see them. The code that draws is compiled once for each arithmetic and
/// instruction set; tests, schedules and reports do not know the type of any component.
namespace fairlight {

/// The largest relative error that the rounding of a Real can give a mean. In double it is 0: no
/// test sees it. In float it is 84 roundings of half an ulp (2^-24) in the same direction, more
/// than any component makes.
template <class Real>
inline constexpr double arithmetic_rounding = lanes<Real> > 1 ? 5e-6 : 0;

/// Widens references for an arithmetic with this relative rounding: the range grows, and the mean
/// may be off by it.
std::vector<Reference> rounded_references(std::vector<Reference> references, double rounding);

template <class Real>
std::vector<Reference> rounded_references(std::vector<Reference> references) {
  return rounded_references(std::move(references), arithmetic_rounding<Real>);
}

/// References for the means of replicates of n points. The range is that of the estimator, widened
/// by the n roundings of the sum in double. rounded_references allows for the rounding of the lanes
/// before the sum.
std::vector<Reference> replicate_references(std::vector<Reference> references, std::uint32_t n);

/// Draws that are made `lanes` at a time: `make(first, places)` puts channel c of draw first + i at
/// places[c][i]. Lanes are cached and handed out one at a time where a test asks for single draws,
/// as it does where the range is wide.
using MakePacket = std::function<void(std::uint64_t first, std::span<double* const> places)>;
DrawBlock draws_at_once(std::size_t lanes, std::size_t channel_count, MakePacket make);

namespace detail {

/// One channel of a draw: the number itself, or a component of a colour.
template <class Value>
auto channel_of(const Value& x, std::size_t c) {
  if constexpr (requires { x.rows(); }) {
    return x[static_cast<Eigen::Index>(c)];
  } else {
    return x;
  }
}

/// One lane of a packet, in double: a number or a vector.
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
  /// Makes one draw (in a packet, one for each lane) and writes its first channels.
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

/// The body that calls `draw(type_identity<Real>, source)`, which gives a Real or an Rgb<Real>.
template <class Real, class Draw>
std::shared_ptr<const Body<Real>> body_of(const Draw& draw) {
  return std::make_shared<const detail::BodyOf<Real, Draw>>(draw);
}

/// The body that calls `draw(source)`.
template <class Real, class Draw>
std::shared_ptr<const Body<Real>> body_of_source(const Draw& draw) {
  return body_of<Real>([draw](std::type_identity<Real>, auto& source) { return Real(draw(source)); });
}

/// The draws of an estimator in one arithmetic. The type does not depend on which.
struct Draws {
  std::size_t lanes;
  double rounding;  ///< relative, see arithmetic_rounding
  /// Draws from independent numbers.
  std::function<DrawBlock(const StreamKey& key)> independent;
  /// Draws that are means of replicates of n Sobol' points. Throws BadDraw for a point outside the
  /// range of its reference.
  std::function<DrawBlock(const StreamKey& key, const std::vector<Reference>& references, std::uint32_t n)>
      replicates;
};

/// The same estimator in double and in packets.
struct PairedDraws {
  Draws in_double, in_packets;
  /// The difference of the draws in double and in packets, lane by lane from the same numbers.
  /// `references` are those of the draws in double. Where a reference has a tail, both are clamped
  /// to its upper bound. Throws BadDraw for a draw in double outside its range.
  std::function<DrawBlock(const StreamKey& key, const std::vector<Reference>& references)> double_minus_packet;
  /// The cost of a packet in draws in double, by how many numbers each takes. A packet takes more
  /// of them where its lanes wait for the longest.
  std::function<double(const StreamKey& key)> draws_a_packet;
};

/// Compiled once for each instruction set, in draws.cpp. `channels` is how many channels are
/// tested.
template <class Real>
Draws draws_of(std::shared_ptr<const Body<Real>> body, std::size_t channels);

template <class Packets>
PairedDraws paired_draws(std::shared_ptr<const Body<double>> in_double,
                         std::shared_ptr<const Body<Packets>> in_packets, std::size_t channels);

/// Draws that are means of replicates of n points, from the numbers of a point set. Throws
/// std::invalid_argument unless a replicate fills whole packets. Throws BadDraw for a point outside
/// the range of its reference, which the mean could hide.
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
