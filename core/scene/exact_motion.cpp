#include "core/scene/exact_motion.hpp"

#include "core/scene/scene_io.hpp"

namespace pf {

template <int D>
ExactMotion<D>::ExactMotion(const Scene& scene) {
  if (scene.exact_position.size() != D)
    throw InputError("", {{"/exact/position", std::to_string(scene.exact_position.size()) + " components",
                           std::to_string(D) + " components"}});
  for (std::size_t a = 0; a < D; ++a) {
    const Formula& formula = scene.exact_position[a];
    try {
      position_[a] = formula.is_number() ? Expression(formula.number)
                                         : Expression::compile(formula.text, scene.constants, mask_reference_time);
    } catch (const ExpressionError& error) {
      throw InputError(
          "", {{"/exact/position/" + std::to_string(a),
                "character " + std::to_string(error.position() + 1) + ": " + error.what(), "expressions in X Y Z t"}});
    }
  }
}

template <int D>
MotionPoint<D> ExactMotion<D>::at(const Vec<D>& X, double t) const {
  std::array<Jet2, variable_count> v;
  for (int A = 0; A < D; ++A) v[static_cast<std::size_t>(A)] = Jet2::variable(X[A], A);
  constexpr int time = Jet2::variables - 1;
  v[var_t] = Jet2::variable(t, time);
  MotionPoint<D> point;
  for (int a = 0; a < D; ++a) {
    const auto component = static_cast<std::size_t>(a);
    const Jet2 phi = position_[component](std::span<const Jet2>(v));
    point.position[a] = phi.value;
    point.velocity[a] = phi.gradient[time];
    point.acceleration[a] = phi.hessian(time, time);
    point.F.row(a) = phi.gradient.template head<D>();
    point.gradient[component] = phi.hessian.template topLeftCorner<D, D>();
  }
  return point;
}

template <int D>
Vec<D> ExactMotion<D>::position(const Vec<D>& X, double t) const {
  std::array<double, variable_count> v{};
  for (int A = 0; A < D; ++A) v[static_cast<std::size_t>(A)] = X[A];
  v[var_t] = t;
  Vec<D> x;
  for (int a = 0; a < D; ++a) x[a] = position_[static_cast<std::size_t>(a)](std::span<const double>(v));
  return x;
}

template class ExactMotion<2>;
template class ExactMotion<3>;

}  // namespace pf
