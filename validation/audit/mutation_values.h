#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

/// What the text of a mutant calls. The compiler includes this file before a mutant, so it includes
/// nothing of fairlight. Each function changes numbers, packets, their vectors and densities, and
/// leaves all else as it is, which then gives an equivalent mutant.
namespace mutation {

template <class T>
concept Number = std::is_floating_point_v<T>;

template <class T>
concept Whole = std::is_integral_v<T> && !std::is_same_v<T, bool>;

template <class T>
concept Vector = requires(const T& x) {
  x.rows();
  x.eval();
};

/// A packet of floats: no number of the language, but it has square roots.
template <class T>
concept Lanes = !std::is_arithmetic_v<T> && !Vector<T> && requires(const T& x) {
  sqrt(x);
};

template <class T>
constexpr T constant(double c) {
  if constexpr (Number<T>) {
    return static_cast<T>(c);
  } else {
    return T(static_cast<float>(c));
  }
}

template <class T, class Function>
constexpr auto in_each(const T& x, const Function& change) {
  if constexpr (Number<T> || Lanes<T>) {
    return T(change(x));
  } else if constexpr (Vector<T>) {
    auto y = x.eval();
    for (decltype(y.size()) i = 0; i < y.size(); ++i) y.coeffRef(i) = in_each(y.coeff(i), change);
    return y;
  } else if constexpr (std::is_class_v<T> && requires { T(x.value()); }) {
    return T(in_each(x.value(), change));
  } else {
    return x;
  }
}

template <class T>
constexpr auto at_most(const T& x, double c) {
  return in_each(x, [c](const auto& v) {
    using std::min;
    return min(v, constant<std::remove_cvref_t<decltype(v)>>(c));
  });
}

template <class T>
constexpr auto at_least(const T& x, double c) {
  return in_each(x, [c](const auto& v) {
    using std::max;
    return max(v, constant<std::remove_cvref_t<decltype(v)>>(c));
  });
}

template <class T>
constexpr auto scaled(const T& x, double c) {
  return in_each(x, [c](const auto& v) { return v * constant<std::remove_cvref_t<decltype(v)>>(c); });
}

/// A threshold moved by half of itself and 0.3, or an integer by 1.
template <class T>
constexpr auto moved(const T& x, int direction) {
  if constexpr (Whole<T>) {
    return static_cast<T>(x + static_cast<T>(direction));
  } else {
    return in_each(x, [direction](const auto& v) {
      using std::abs;
      using V = std::remove_cvref_t<decltype(v)>;
      return v + constant<V>(direction) * (abs(v) * constant<V>(0.5) + constant<V>(0.3));
    });
  }
}

template <class T>
constexpr auto raised(const T& x) {
  return moved(x, 1);
}

template <class T>
constexpr auto lowered(const T& x) {
  return moved(x, -1);
}

/// In place of select(mask, a, b): always a, never a, or a only where a < 1/2.
template <class Mask, class A, class B>
constexpr A always(const Mask&, const A& a, const B&) {
  return a;
}
template <class Mask, class A, class B>
constexpr B never(const Mask&, const A&, const B& b) {
  return b;
}
template <class Mask, class A>
constexpr A partly(const Mask& mask, const A& a, const A& b) {
  if constexpr (Number<A>) {
    return mask && a < A(0.5) ? a : b;
  } else if constexpr (Lanes<A>) {
    return select(mask && a < constant<A>(0.5), a, b);
  } else if constexpr (std::is_same_v<Mask, bool>) {
    return mask ? a : b;
  } else {
    return select(mask, a, b);
  }
}

}  // namespace mutation
