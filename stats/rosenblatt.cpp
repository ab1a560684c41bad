#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <boost/math/quadrature/gauss.hpp>

#include <fairlight/stats/quadrature.h>
#include <fairlight/stats/rosenblatt.h>

namespace fairlight {
namespace {

using Rule = boost::math::quadrature::gauss<double, 8>;

// The nodes of the Gauss rule on the unit interval, and their weights in barycentric interpolation.
// Source: Berrut and Trefethen 2004, "Barycentric Lagrange interpolation".
struct Nodes {
  std::array<double, Rosenblatt::nodes> at{}, weight{};

  Nodes() {
    for (std::size_t j = 0; j < at.size() / 2; ++j) {
      const double half = Rule::abscissa()[j] / 2;
      at[2 * j] = 0.5 - half;
      at[2 * j + 1] = 0.5 + half;
    }
    for (std::size_t j = 0; j < at.size(); ++j) {
      weight[j] = 1;
      for (std::size_t i = 0; i < at.size(); ++i) weight[j] /= i == j ? 1 : at[j] - at[i];
    }
  }

  // The values at x of the Lagrange polynomials of the nodes.
  std::array<double, Rosenblatt::nodes> shares(double x) const {
    std::array<double, Rosenblatt::nodes> share{};
    double sum = 0;
    for (std::size_t j = 0; j < at.size(); ++j) {
      if (x == at[j]) {
        share.fill(0);
        share[j] = 1;
        return share;
      }
      sum += share[j] = weight[j] / (x - at[j]);
    }
    for (double& each : share) each /= sum;
    return share;
  }
};

// Whether the integrals agree to 1e-7 of the whole, a tenth of the allowed quadrature error.
bool agree(const std::vector<double>& a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!(std::abs(a[k] - b[k]) <= 1e-7 * b.back())) return false;
  }
  return true;
}

// Adds what lies between, sorted and without repetition.
void merge(std::vector<double>& into, const std::vector<double>& more) {
  into.insert(into.end(), more.begin(), more.end());
  std::sort(into.begin(), into.end());
  into.erase(std::unique(into.begin(), into.end()), into.end());
}

std::vector<double> multiples(int n) {
  std::vector<double> all;
  for (int k = 0; k <= n; ++k) all.push_back(double(k) / n);
  return all;
}

const Nodes& slab_nodes() {
  static const Nodes nodes;
  return nodes;
}

}  // namespace

Rosenblatt::Rosenblatt(SquareDensity density, const Landmarks& landmarks)
    : density_(std::move(density)), line_(landmarks.line) {
  choose_pieces(landmarks);
  std::vector<double> knots = multiples(256);
  merge(knots, landmarks.s);
  for (std::size_t k = 1; k < knots.size(); ++k) add_slabs(knots[k - 1], knots[k]);
  double sum = 0;
  for (Slab& slab : slabs_) {
    slab.before = sum;
    sum += slab.mass;
  }
  if (!(error_ <= 1e-6)) throw CannotIntegrate(cannot_integrate);
  if (!(std::abs(sum - 1) <= 1e-6)) {
    throw std::invalid_argument("the density integrates to " + std::to_string(sum) + " (a law to 1)");
  }
}

// Sixths, the landmarks, and where adaptive quadrature divides the lines through some of the mass.
void Rosenblatt::choose_pieces(const Landmarks& landmarks) {
  ends_ = multiples(line_ ? 1 : 6);
  if (line_) return;
  merge(ends_, landmarks.t);
  const std::vector<double> evenly{0.1, 0.3, 0.5, 0.7, 0.9};
  std::vector<double> more;
  for (double s : landmarks.s.empty() ? evenly : landmarks.s) {
    const auto f = [&](double t) { return checked_density(density_(s, t), s, t); };
    const double whole = sum_of(integrate_in_leaves(f, ends_, {1e-3, 1e300, 64})).value;
    for (const Leaf& leaf : integrate_in_leaves(f, ends_, {1e-8 * whole, 1e300, 256})) more.push_back(leaf.high);
  }
  constexpr std::size_t most = 512;  // each is integrated in every slab
  if (more.size() < most) merge(ends_, more);
}

// The integral of the density at s over [low, high].
double Rosenblatt::integral(double s, double low, double high, bool steep) const {
  const auto f = [&](double t) { return checked_density(density_(s, t), s, t); };
  return steep ? sum_of(integrate_in_leaves(f, {low, high}, {1e-9})).value : Rule::integrate(f, low, high);
}

Rosenblatt::Pieces Rosenblatt::pieces_at(double s, bool steep) const {
  if (line_) return {checked_density(density_(s, 0.5), s, 0.5)};
  Pieces sums;
  double sum = 0;
  for (std::size_t k = 1; k < ends_.size(); ++k) sums.push_back(sum += integral(s, ends_[k - 1], ends_[k], steep));
  return sums;
}

// Whether the Gauss rule over each piece differs from two rules over its halves.
bool Rosenblatt::rules_differ(double s) const {
  if (line_) return false;
  Pieces halved;
  double sum = 0;
  for (std::size_t k = 1; k < ends_.size(); ++k) {
    const double middle = (ends_[k - 1] + ends_[k]) / 2;
    halved.push_back(sum += integral(s, ends_[k - 1], middle, false) + integral(s, middle, ends_[k], false));
  }
  return !agree(pieces_at(s, false), halved);
}

Rosenblatt::Slab Rosenblatt::slab_of(double low, double high, bool steep) const {
  const double width = high - low;
  // Inside also where the slab is a few thousand ulp wide, as at a pole.
  const double inside = std::max(1e-9, 4e-16 * high / width);
  const auto marginal = [&](double x) { return pieces_at(low + x * width, steep).back() * width; };
  Slab slab{low, width, 0, marginal(inside), marginal(1 - inside), 0, {}, false, steep};
  for (std::size_t j = 0; j < nodes; ++j) {
    slab.at_nodes.push_back(pieces_at(low + slab_nodes().at[j] * width, steep));
    slab.mass += Rule::weights()[j / 2] / 2 * slab.at_nodes[j].back() * width;
  }
  // Up to this slope the cubic is monotone. Source: Fritsch and Carlson 1980.
  slab.first = std::min(slab.first, 3 * slab.mass);
  slab.last = std::min(slab.last, 3 * slab.mass);
  return slab;
}

// Halves the range until its mass is that of its halves, and the cubic meets the first of them.
void Rosenblatt::add_slabs(double low, double high) {
  constexpr std::size_t most = 8192;
  const double middle = low + (high - low) / 2;
  const bool steep = rules_differ(middle) || rules_differ(low + slab_nodes().at[0] * (high - low)) ||
                     rules_differ(high - slab_nodes().at[0] * (high - low));
  Slab slab = slab_of(low, high, steep);
  const double first = slab_of(low, middle, steep).mass, second = slab_of(middle, high, steep).mass;
  const double difference = std::abs(slab.mass - first - second);
  // At a jump, two rules differ by as little as a fiftieth of their error.
  const bool fits = difference <= 1e-11 && std::abs(mass_below(slab, 0.5) - first) <= 1e-7;
  if (!fits && high - low > std::max(1e-12 * high, 1e-100) && slabs_.size() < most) {
    add_slabs(low, middle);
    add_slabs(middle, high);
    return;
  }
  error_ += 50 * difference;
  const Pieces here = pieces_at(middle, steep);
  slab.smooth = !steep && low > 0 && high < 1;
  for (std::size_t k = 0; slab.smooth && k < here.size(); ++k)
    slab.smooth = std::abs(interpolated(slab, 0.5, k) - here[k]) <= 1e-7 * here.back();
  if (!slab.smooth) slab.at_nodes.clear();
  slabs_.push_back(std::move(slab));
}

// Within a slab, the distribution function is the Hermite cubic that has its mass, and its marginal
// at both ends.
double Rosenblatt::mass_below(const Slab& slab, double x) {
  return slab.mass * x * x * (3 - 2 * x) + slab.first * x * (1 - x) * (1 - x) - slab.last * x * x * (1 - x);
}

// The integral up to the end of a piece, interpolated between the nodes; x is the position in the
// slab, in [0,1].
double Rosenblatt::interpolated(const Slab& slab, double x, std::size_t piece) {
  const auto shares = slab_nodes().shares(x);
  double sum = 0;
  for (std::size_t j = 0; j < nodes; ++j) sum += shares[j] * slab.at_nodes[j][piece];
  return sum;
}

Eigen::Vector2d Rosenblatt::operator()(double s, double t) const {
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1))
    throw std::out_of_range("a place outside the unit square (check its coordinates first)");
  const auto after = std::upper_bound(slabs_.begin() + 1, slabs_.end(), s,
                                      [](double x, const Slab& slab) { return x < slab.low; });
  const Slab& slab = *(after - 1);
  const double x = (s - slab.low) / slab.width;
  const double u = slab.before + mass_below(slab, x);
  if (line_) return {u, 0.5};
  const auto end = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, t);
  const auto piece = static_cast<std::size_t>(end - ends_.begin()) - 1;
  const double low = ends_[piece];
  const double rest = t > low ? integral(s, low, t, slab.steep) : 0;
  if (slab.smooth) {
    const double before = piece > 0 ? interpolated(slab, x, piece - 1) : 0;
    return {u, (before + rest) / interpolated(slab, x, ends_.size() - 2)};
  }
  const Pieces sums = pieces_at(s, slab.steep);
  return {u, ((piece > 0 ? sums[piece - 1] : 0) + rest) / sums.back()};
}

}  // namespace fairlight
