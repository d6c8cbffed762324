// Looking inside a simulation and recording a step: the numbers are the step's own, and taking them changes none.
#include "core/look.hpp"

#include <algorithm>
#include <map>

#include "core/bases/basis.hpp"
#include "core/grid/domain.hpp"
#include "tests/simulation/scenes.hpp"

using namespace pf;
using namespace pf::test;

namespace {

Json spinning(int dimension, const std::string& basis = "quadratic", const char* transfer = "flip") {
  Json scene = block(dimension);
  scene["grid"]["basis"] = basis;
  scene["transfer"]["type"] = transfer;
  scene["gravity"] = point(dimension, 0, -9.81);
  scene["bodies"][0]["velocity"] = dimension == 2 ? Json{"-6*Y", "6*X"} : Json{"-6*Y", "6*X", "0.5"};
  return scene;
}

Vec3 component(const std::vector<double>& values, std::size_t i, int d) {
  Vec3 v = Vec3::Zero();
  for (int a = 0; a < d; ++a) v[a] = values[i * static_cast<std::size_t>(d) + static_cast<std::size_t>(a)];
  return v;
}

std::map<NodeIndex, std::size_t> nodes_of(const StepRecord& r) {
  std::map<NodeIndex, std::size_t> found;
  for (std::size_t i = 0; i < r.nodes(); ++i) {
    NodeIndex index{};
    std::copy_n(r.node_index.begin() + static_cast<long>(i) * r.dimension, r.dimension, index.begin());
    found[index] = i;
  }
  return found;
}

}  // namespace

TEST_CASE("a particle's weights add up to 1, their gradients to 0, and they put it where it is") {
  for (const int d : {2, 3})
    for (const BasisInfo& info : bases()) {
      const std::string basis(info.name);
      CAPTURE(d);
      CAPTURE(basis);
      const auto simulation = start(spinning(d, basis));
      run(*simulation, 3);
      for (const std::uint32_t id : {0u, 7u, static_cast<std::uint32_t>(simulation->particle_count() - 1)}) {
        const Look look = simulation->look({id, std::nullopt});
        REQUIRE(look.particle);
        const ParticleLook& p = *look.particle;
        CHECK(look.step == 3);
        const int K = info.nodes_per_axis;
        CHECK(p.nodes.size() == static_cast<std::size_t>(d == 2 ? K * K : K * K * K));
        CHECK(p.weight_sum == doctest::Approx(1).epsilon(1e-13));
        CHECK(p.gradient_sum.norm() < 1e-11);
        CHECK((p.position_sum - p.state.x).norm() < 1e-14);
        CHECK(p.J == doctest::Approx(p.stretches.prod()).epsilon(1e-12));
        CHECK(p.stretches[0] >= p.stretches[1]);
      }
      CHECK_FALSE(simulation->look({static_cast<std::uint32_t>(simulation->particle_count()), std::nullopt}).particle);
    }
}

TEST_CASE("what particles give to a node is what the next step finds there") {
  for (const int d : {2, 3})
    for (const char* transfer : {"flip", "apic"}) {
      CAPTURE(d);
      CAPTURE(transfer);
      const auto simulation = start(spinning(d, "quadratic", transfer));
      run(*simulation, 2);
      const ParticleLook p = *simulation->look({5, std::nullopt}).particle;
      std::vector<NodeLook> before;
      for (const NodeWeight& n : p.nodes) before.push_back(*simulation->look({std::nullopt, n.node}).node);
      simulation->set_recording(RecordLevel::all);
      run(*simulation, 1);
      REQUIRE(simulation->record());
      const StepRecord& r = *simulation->record();
      CHECK(r.step == 3);
      const auto nodes = nodes_of(r);
      for (std::size_t k = 0; k < before.size(); ++k) {
        const NodeLook& n = before[k];
        REQUIRE(n.active);
        const std::size_t i = nodes.at(n.node);
        CHECK(n.mass == doctest::Approx(r.node_mass[i]).epsilon(1e-12));
        CHECK((n.velocity - component(r.node_velocity, i, d)).norm() < 1e-10 * (1 + n.velocity.norm()));
        const double force = 1e-9 * (1 + n.internal.norm() + n.external.norm());
        CHECK((n.internal - component(r.internal_start, i, d)).norm() < force);
        CHECK((n.external - component(r.external_start, i, d)).norm() < force);
        // The particle that was looked at is among those who give, with its own weight.
        const auto mine =
            std::find_if(n.largest.begin(), n.largest.end(), [](const auto& c) { return c.particle == 5; });
        if (n.contributors <= most_contributions) {
          REQUIRE(mine != n.largest.end());
          CHECK(mine->w == doctest::Approx(p.nodes[k].w).epsilon(1e-12));
          double mass = 0;
          for (const Contribution& c : n.largest) mass += c.mass;
          CHECK(mass == doctest::Approx(n.mass).epsilon(1e-12));
        }
      }
      CHECK_FALSE(simulation->look({std::nullopt, NodeIndex{1000, 0, 0}}).node->active);
    }
}

TEST_CASE(
    "what the particles tell adds up to the masses and forces of the step, for every basis, sheared and at walls") {
  for (const int d : {2, 3})
    for (const BasisInfo& info : bases())
      for (const bool at_wall : {false, true}) {
        const std::string basis(info.name);
        CAPTURE(d);
        CAPTURE(basis);
        CAPTURE(at_wall);
        Json scene = spinning(d, basis);
        scene["bodies"][0]["velocity"] = d == 2 ? Json{"30*Y", "0"} : Json{"30*Y", "0", "4*X"};
        if (at_wall) {
          scene["boundaries"] = Json::array({floor_at(d, 0.1)});
          scene["grid"]["boundary_correction"] = true;
        }
        const auto simulation = start(scene);
        run(*simulation, 2);
        std::map<NodeIndex, double> mass;
        std::map<NodeIndex, Vec3> force;
        double sheared = 0;
        for (const ParticleState& p : simulation->particles()) {
          sheared = std::max(sheared, std::abs(p.F(0, 1)));
          const ParticleLook look = *simulation->look({p.id, std::nullopt}).particle;
          CHECK(look.weight_sum == doctest::Approx(1).epsilon(1e-12));
          CHECK(look.gradient_sum.norm() < 1e-11);
          for (const NodeWeight& n : look.nodes) {
            mass[n.node] += p.mass * n.w;
            force.try_emplace(n.node, Vec3::Zero()).first->second -= p.volume0 * look.J * p.sigma * n.grad;
          }
        }
        CHECK(sheared > 0.3);  // in 3D, too, a domain is cut into pieces
        const NodeIndex inside{4, 3, d == 3 ? 3 : 0};
        const NodeLook node = *simulation->look({std::nullopt, inside}).node;
        REQUIRE(node.active);
        CHECK(node.mass == doctest::Approx(mass.at(inside)).epsilon(1e-12));
        CHECK((node.internal - force.at(inside)).norm() < 1e-11 * (1 + node.internal.norm()));

        simulation->set_recording(RecordLevel::all);
        run(*simulation, 1);
        const StepRecord& r = *simulation->record();
        const double heaviest = *std::max_element(r.node_mass.begin(), r.node_mass.end());
        double strongest = 0, mass_off = 0, force_off = 0;
        const auto nodes = nodes_of(r);
        for (const auto& [index, i] : nodes) {
          REQUIRE(mass.count(index) == 1);
          const Vec3 f = component(r.internal_start, i, d);
          strongest = std::max(strongest, f.norm());
          mass_off = std::max(mass_off, std::abs(mass[index] - r.node_mass[i]));
          Vec3 told = force[index];
          if (d == 2) told.z() = 0;
          force_off = std::max(force_off, (told - f).norm());
        }
        CHECK(mass_off < 1e-12 * heaviest);
        CHECK(strongest > 1);
        CHECK(force_off < 1e-11 * strongest);
        for (const auto& [index, m] : mass)
          if (nodes.count(index) == 0) CHECK(m == 0);
      }
}

TEST_CASE("the pieces of a domain along an axis give the plan's weights, added up over the other axes") {
  for (const int d : {2, 3})
    for (const char* name : {"gimp", "quadratic_gimp"}) {
      CAPTURE(d);
      CAPTURE(name);
      Json scene = spinning(d, name);
      scene["bodies"][0]["velocity"] = d == 2 ? Json{"30*Y", "0"} : Json{"30*Y", "0", "4*X"};
      const auto simulation = start(scene);
      run(*simulation, 2);
      const std::vector<ParticleState> all = simulation->particles();
      const auto sheared = std::max_element(all.begin(), all.end(), [](const auto& p, const auto& q) {
        return std::abs(p.F(0, 1)) < std::abs(q.F(0, 1));
      });
      const ParticleLook look = *simulation->look({sheared->id, std::nullopt}).particle;
      const double l_0 = 1.0 / simulation->scene().bodies[0].particles_per_axis;
      const BasisInfo& basis = *find_basis(name);
      for (int a = 0; a < d; ++a) {
        const Mat<2> flat = l_0 * look.state.F.topLeftCorner<2, 2>();
        const Mat<3> whole = l_0 * look.state.F;
        const auto pieces = d == 2 ? domain_pieces<2>(flat.data(), a) : domain_pieces<3>(whole.data(), a);
        CHECK(pieces.size() > 1);
        const double s = look.state.x[a] / 0.1;
        const auto base = static_cast<double>(look.nodes.front().node[static_cast<std::size_t>(a)]);
        for (int r = 0; r < basis.nodes_per_axis; ++r) {
          double sum = 0, along = 0;
          for (const NodeWeight& n : look.nodes)
            if (n.node[static_cast<std::size_t>(a)] == static_cast<int>(base) + r) sum += n.w;
          for (const DomainPiece& p : pieces) {
            FourNumbers N[max_nodes_per_axis], dN[max_nodes_per_axis];
            basis.mean_four(FourNumbers{} + (s + p.at - base), FourNumbers{} + p.width, N, dN);
            along += p.share * N[r][0];
          }
          CHECK(along == doctest::Approx(sum).epsilon(1e-11));
        }
      }
    }
}

TEST_CASE("a recorded step balances its forces at every iterate and moves the particles as it says") {
  for (const int d : {2, 3}) {
    CAPTURE(d);
    Json scene = spinning(d);
    scene["bodies"][0]["velocity"][0] = "3-6*Y";  // across cells
    const auto simulation = start(scene);
    run(*simulation, 2);
    simulation->set_recording(RecordLevel::all);
    run(*simulation, 1);
    const StepReport& report = simulation->report();
    const StepRecord& r = *simulation->record();
    REQUIRE(r.accepted);
    REQUIRE(r.stages.size() == 1);
    CHECK(r.stages[0].scale == doctest::Approx(1 / (r.dt * r.dt)));
    REQUIRE(r.iterates.size() == report.newton.size());
    REQUIRE(r.iterates.size() >= 2);
    for (std::size_t k = 0; k < r.iterates.size(); ++k) {
      const IterateRecord& it = r.iterates[k];
      CHECK(it.newton.residual == report.newton[k].residual);
      CHECK(it.newton.linear_iterations == report.newton[k].linear_iterations);
      REQUIRE(it.worst >= 0);
      CHECK(it.worst_share > 0);
      CHECK(it.worst_share <= 1);
      double off = 0, size = 0;
      for (std::size_t i = 0; i < it.residual.size(); ++i) {
        off = std::max(off, std::abs(it.inertia[i] - it.internal[i] - r.stages[0].given[i] - it.residual[i]));
        size = std::max(size, std::abs(it.inertia[i]) + std::abs(it.internal[i]));
      }
      CHECK(off < 1e-11 * size);  // free: nothing else takes a part of the balance
    }
    CHECK(r.iterates.back().u == r.node_displacement);
    CHECK(r.iterates.back().newton.residual < 1e-6);

    const auto nodes = nodes_of(r);
    const BasisInfo& basis = *find_basis("quadratic");
    std::size_t resorted = 0;
    const std::vector<ParticleState> all = simulation->particles();
    Snapshot now_sorted;
    simulation->capture({}, now_sorted);
    for (std::size_t p = 0; p < r.id.size(); ++p) {
      resorted += now_sorted.id[p] == r.id[p] ? 0 : 1;
      const auto D = static_cast<std::size_t>(d);
      const Vec3 x = component(r.before.x, p, d);
      Vec3 moved = Vec3::Zero();
      Mat3 F_hat = Mat3::Identity(), F = Mat3::Identity(), F_after = Mat3::Identity();
      for (const NodeWeight& n : weights_at(basis, r.spacing, d, x)) {
        const Vec3 u = component(r.node_displacement, nodes.at(n.node), d);
        moved += n.w * u;
        F_hat += u * n.grad.transpose();
      }
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) {
          const std::size_t at = p * D * D + static_cast<std::size_t>(a + d * b);
          F(a, b) = r.before.F[at];
          F_after(a, b) = r.after.F[at];
        }
      CHECK((x + moved - component(r.after.x, p, d)).norm() < 1e-14);
      CHECK((F_hat * F - F_after).norm() < 1e-12);
      const ParticleState& now = all[r.id[p]];
      CHECK((now.x - component(r.after.x, p, d)).norm() == 0);
      CHECK((now.v - component(r.after.v, p, d)).norm() == 0);
      CHECK((now.F.topLeftCorner(d, d) - F_after.topLeftCorner(d, d)).norm() == 0);
    }
    CHECK(resorted > 0);  // the next step's order is another one, the record keeps to its own
  }
}

TEST_CASE("a recorded step has its own weights, averaged over turned domains and ended at walls") {
  for (const int d : {2, 3}) {
    for (const char* basis : {"quadratic", "gimp"}) {
      CAPTURE(d);
      CAPTURE(basis);
      const auto simulation = make_simulation(parse_scene(spinning(d, basis).dump(), "test"), {1, ""});
      for (int k = 0; k < 10; ++k) simulation->step();
      simulation->set_recording(RecordLevel::all);
      REQUIRE(simulation->step().status == StepStatus::accepted);
      const StepRecord& r = *simulation->record();
      const auto nodes = nodes_of(r);
      double largest = 0, worst = 0, centre = 0;
      for (std::size_t p = 0; p < r.id.size(); ++p) {
        const Vec3 x = component(r.before.x, p, d), after = component(r.after.x, p, d);
        Vec3 moved = Vec3::Zero(), by_centre = Vec3::Zero();
        double sum = 0;
        for (const NodeWeight& n : recorded_weights(r, p)) {
          sum += n.w;
          if (const auto at = nodes.find(n.node); at != nodes.end())
            moved += n.w * component(r.node_displacement, at->second, d);
          else
            CHECK(n.w == 0);
        }
        for (const NodeWeight& n : weights_at(*find_basis(basis), r.spacing, d, x))
          if (const auto at = nodes.find(n.node); at != nodes.end())
            by_centre += n.w * component(r.node_displacement, at->second, d);
        CHECK(sum == doctest::Approx(1).epsilon(1e-6));
        largest = std::max(largest, (after - x).norm());
        worst = std::max(worst, (x + moved - after).norm());
        centre = std::max(centre, (x + by_centre - after).norm());
      }
      CHECK(worst < 1e-6 * largest);
      if (find_basis(basis)->averaged()) CHECK(centre > 1e-4 * largest);  // what the centre alone would tell
    }
  }
}

TEST_CASE("recording changes no bit of a step and none of the counted work, under any integrator") {
  for (const char* integrator :
       {"backward_euler", "implicit_midpoint", "trapezoidal", "tr_bdf2", "generalized_alpha", "symplectic_euler"}) {
    CAPTURE(integrator);
    Json scene = spinning(2);
    scene["integrator"]["type"] = integrator;
    scene["time"]["step"] = 0.002;
    scene["boundaries"] = Json::array({floor_at(2, 0.05)});
    scene["boundaries"][0]["friction"] = 0.3;
    const auto plain = start(scene), recorded = start(scene);
    recorded->set_recording(RecordLevel::all);
    run(*plain, 20);
    run(*recorded, 20);
    CHECK(state_of(*plain) == state_of(*recorded));
    CHECK(plain->report().work.gradient == recorded->report().work.gradient);
    CHECK(plain->report().work.hessian_product == recorded->report().work.hessian_product);
    CHECK_FALSE(plain->record());
    REQUIRE(recorded->record());
    const bool explicit_step = std::string(integrator) == "symplectic_euler";
    CHECK(recorded->record()->iterates.empty() == explicit_step);
    CHECK(recorded->record()->node_displacement.size() == 2 * recorded->record()->nodes());
    recorded->set_recording(RecordLevel::none);
    run(*recorded, 1);
    CHECK_FALSE(recorded->record());
  }
}

TEST_CASE("the residual of a recorded step can be looked up at its nodes") {
  const auto simulation = start(spinning(2));
  const NodeIndex inside{3, 3, 0};
  run(*simulation, 1);
  CHECK_FALSE(simulation->look({std::nullopt, inside}).node->residual);
  simulation->set_recording(RecordLevel::residuals);
  run(*simulation, 1);
  const StepRecord& r = *simulation->record();
  CHECK(r.before.x.empty());
  CHECK(r.iterates.front().u.empty());
  CHECK(r.iterates.front().residual.empty());
  const NodeLook node = *simulation->look({std::nullopt, inside}).node;
  REQUIRE(node.residual);
  CHECK(*node.residual == component(r.iterates.back().residual, nodes_of(r).at(inside), 2));
}
