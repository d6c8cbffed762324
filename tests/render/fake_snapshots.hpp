// Hand-made snapshots: plausible pictures without a simulation.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/snapshot.hpp"

namespace pf::fake {

inline void set_field(Snapshot& s, Field field, const std::function<float(std::size_t)>& value) {
  auto& values = s.field[static_cast<std::size_t>(field)];
  values.resize(s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) values[p] = value(p);
}

/// Adds a square block of n x n particles of spacing h, deformed by `map` (position and its gradient by
/// differences), lower left corner at `from`.
inline void add_block(Snapshot& s, int n, double h, const Vec<2>& from, std::uint16_t body,
                      const std::function<Vec<2>(const Vec<2>&)>& map) {
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Vec<2> X = from + h * Vec<2>(i + 0.5, j + 0.5);
      const Vec<2> x = map(X);
      const double e = 1e-5 * h;
      const Vec<2> Fx = (map(X + Vec<2>(e, 0)) - map(X - Vec<2>(e, 0))) / (2 * e);
      const Vec<2> Fy = (map(X + Vec<2>(0, e)) - map(X - Vec<2>(0, e))) / (2 * e);
      s.id.push_back(static_cast<std::uint32_t>(s.particles++));
      s.body.push_back(body);
      s.material.push_back(body);
      s.x.insert(s.x.end(), {x.x(), x.y()});
      for (const double f : {Fx.x(), Fx.y(), Fy.x(), Fy.y()}) s.F.push_back(static_cast<float>(f));
      s.volume0.push_back(static_cast<float>(h * h));
    }
  }
}

inline float det2(const Snapshot& s, std::size_t p) {
  return s.F[4 * p] * s.F[4 * p + 3] - s.F[4 * p + 1] * s.F[4 * p + 2];
}

/// Active nodes (quadratic support) around the particles, moving as `velocity` says.
inline void add_nodes(Snapshot& s, const std::function<Vec<2>(const Vec<2>&)>& velocity, double dt, double floor) {
  std::vector<std::pair<int, int>> nodes;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const int i = static_cast<int>(std::lround(s.x[2 * p] / s.spacing)),
              j = static_cast<int>(std::lround(s.x[2 * p + 1] / s.spacing));
    for (int b = -1; b < 2; ++b)
      for (int a = -1; a < 2; ++a) nodes.emplace_back(i + a, j + b);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  s.nodes = nodes.size();
  for (const auto& [i, j] : nodes) {
    const Vec<2> v = velocity(s.spacing * Vec<2>(i, j));
    s.node_index.insert(s.node_index.end(), {i, j});
    s.node_velocity.insert(s.node_velocity.end(), {v.x(), v.y()});
    s.node_displacement.insert(s.node_displacement.end(), {dt * v.x(), dt * v.y()});
    s.node_mass.push_back(1);
    s.node_state.push_back(s.spacing * j < floor + 1e-3 ? 2 : 0);
  }
}

/// Two blocks above a floor, one rotated and bent, in a scene with a floor, a ball, a clamp and a load.
inline Snapshot two_blocks(const Vec<2>& shift = Vec<2>::Zero(), int n = 40) {
  Snapshot s;
  s.dimension = 2;
  s.spacing = 0.05;
  s.report.time = 0.72;
  s.report.step = 43;
  s.report.dt = 1.0 / 60;
  const double h = 1.0 / n;
  const auto bent = [=](const Vec<2>& X) -> Vec<2> {
    const double a = 0.35 + 0.5 * (X.x() - 0.5);
    const Vec<2> q = X - Vec<2>(0.5, 0.5);
    return shift + Vec<2>(0.2, 0.75) +
           Vec<2>(std::cos(a) * q.x() - std::sin(a) * q.y(), std::sin(a) * q.x() + std::cos(a) * q.y());
  };
  const auto squashed = [=](const Vec<2>& X) -> Vec<2> {
    const double y = X.y();
    return shift + Vec<2>(1.6 + (X.x() - 0.5) * (1 + 0.3 * (1 - y) * (1 - y)), 0.05 + 0.8 * y + 0.05 * y * y);
  };
  add_block(s, n, h, {0, 0}, 0, bent);
  add_block(s, n, h, {0, 0}, 1, squashed);
  set_field(s, Field::J, [&](std::size_t p) { return det2(s, p); });
  set_field(s, Field::speed, [&](std::size_t p) {
    const double x = s.x[2 * p] - shift.x(), y = s.x[2 * p + 1] - shift.y();
    return static_cast<float>(2 * std::hypot(x - 0.2, y - 0.75) + 0.1);
  });
  const auto whirl = [&](const Vec<2>& x) -> Vec<2> {
    return 2 * Vec<2>(-(x.y() - shift.y() - 0.75), x.x() - shift.x() - 0.2);
  };
  add_nodes(s, whirl, 0.02, shift.y() + 0.05);
  auto scene = std::make_shared<SceneView>();
  const double inf = INFINITY;
  scene->boundaries.push_back(
      {[=](const Vec3& p) { return p.y() - shift.y() - 0.05; }, Vec3::Constant(-inf), {inf, 0.05, inf}, "separate"});
  const Vec3 ball(shift.x() - 0.7, shift.y() + 0.35, 0);
  scene->boundaries.push_back({[=](const Vec3& p) { return std::hypot(p.x() - ball.x(), p.y() - ball.y()) - 0.3; },
                               ball - Vec3(0.3, 0.3, 0), ball + Vec3(0.3, 0.3, 0), "slip"});
  const auto box = [shift](Vec<2> min, Vec<2> max) {
    return [=](const Vec3& p) {
      const Vec<2> q = (p.head<2>() - shift - 0.5 * (min + max)).cwiseAbs() - 0.5 * (max - min);
      return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
    };
  };
  scene->regions.push_back({box({1.05, 0.05}, {2.2, 0.15}), {1.05, 0.05, 0}, {2.2, 0.15, 0}, "constraint"});
  scene->regions.push_back({box({1.1, 0.9}, {2.1, 0.9}), {1.1, 0.9, 0}, {2.1, 0.9, 0}, "load"});
  scene->material_names = {"rubber", "gel"};
  scene->body_names = {"left", "right"};
  s.scene = scene;
  s.boundary_displacement.assign(2, Vec3::Zero());
  return s;
}

/// A bar of nx x ny x nz particles of spacing h, twisted about its long axis y, standing on the ground y = 0, with a
/// ball beside it.
inline Snapshot twisted_bar(int nx = 10, int ny = 30, int nz = 10, const Vec3& shift = Vec3::Zero()) {
  Snapshot s;
  s.dimension = 3;
  s.report.time = 0.4;
  s.report.step = 24;
  s.report.dt = 1.0 / 60;
  const double h = 1.0 / ny;
  s.spacing = 2 * h;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const Vec3 X((i + 0.5 - 0.5 * nx) * h, (j + 0.5) * h, (k + 0.5 - 0.5 * nz) * h);
        const double a = 1.6 * X.y(), c = std::cos(a), t = std::sin(a);
        const Vec3 x(c * X.x() + t * X.z(), X.y(), -t * X.x() + c * X.z());
        Mat3 F;
        F << c, 1.6 * (-t * X.x() + c * X.z()), t, 0, 1, 0, -t, 1.6 * (-c * X.x() - t * X.z()), c;
        s.id.push_back(static_cast<std::uint32_t>(s.particles++));
        s.body.push_back(0);
        s.material.push_back(0);
        for (int q = 0; q < 3; ++q) s.x.push_back(x[q] + shift[q]);
        for (int q = 0; q < 9; ++q) s.F.push_back(static_cast<float>(F(q % 3, q / 3)));
        s.volume0.push_back(static_cast<float>(h * h * h));
        s.field[0].push_back(static_cast<float>(1.6 * X.y() * std::hypot(X.x(), X.z()) * 10));
      }
    }
  }
  auto scene = std::make_shared<SceneView>();
  const double inf = INFINITY;
  scene->boundaries.push_back(
      {[=](const Vec3& p) { return p.y() - shift.y(); }, Vec3::Constant(-inf), {inf, shift.y(), inf}, "separate"});
  const Vec3 ball = shift + Vec3(0.5, 0.2, 0.1);
  scene->boundaries.push_back({[=](const Vec3& p) { return (p - ball).norm() - 0.2; }, ball - Vec3::Constant(0.2),
                               ball + Vec3::Constant(0.2), "slip"});
  const Vec3 box = shift + Vec3(-0.55, 0.12, 0.15), half(0.15, 0.12, 0.2);
  scene->boundaries.push_back({[=](const Vec3& p) {
                                 const Vec3 q = (p - box).cwiseAbs() - half;
                                 return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
                               },
                               box - half, box + half, "slip"});
  scene->material_names = {"rubber"};
  scene->body_names = {"bar"};
  s.scene = scene;
  s.boundary_displacement.assign(3, Vec3::Zero());
  return s;
}

}  // namespace pf::fake
