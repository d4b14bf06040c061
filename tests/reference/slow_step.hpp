// SPDX-License-Identifier: BSD-3-Clause
// The time step as the paper prints it, loops over particles and nodes, to read and to compare the fast step with.
// Tests: tests/reference/slow_step_test.cpp
#pragma once

#include "boundary/damping.hpp"
#include "material/increment.hpp"
#include "mesh/mesh.hpp"

namespace berm::reference {

/// A term of the step, which it may leave out.
enum class Term {
  none,
  internal_force,
  gravity,
  damping,
  supports,
  remapping,
  rotation,
  volume,
  law,
  hoop_stress,
  hoop_strain,
  first_contact,
  second_contact,
  friction
};

/// A particle with the state variables of its law.
template <int dim>
struct Particle {
  Vec<dim> x, v;          ///< m, m/s
  SymTensor<dim> stress;  ///< Pa, tension positive
  Real mass, volume;      ///< kg, m3; per metre run in the plane, per radian around an axis
  std::array<Real, 8> state;
  Index cell;
};

/// A rigid half-space at rest, which soil touches at the nodes of the cells that it cuts.
template <int dim>
struct HalfSpace {
  Vec<dim> point, normal;  ///< m, on its surface; unit vector out of it
  Real friction;           ///< coefficient
};

/// One deformable body, and the step that takes it further: modified update stress last without water, by one prepared law
/// (material/law_list.hpp).
template <int dim, class Law>
struct SlowStep {
  const mesh::Mesh<dim>& mesh;
  Law law;
  Real min_volume, max_volume;     ///< of a particle over its mass, m3/kg
  Vec<dim> gravity;                ///< m/s2
  NodeField<Real> damping_factor;  ///< of local damping
  NodeField<std::uint8_t> held;    ///< bit d: the support of the node holds direction d
  std::vector<Particle<dim>> particles;
  std::optional<HalfSpace<dim>> rigid;
  Real time = 0;                ///< s
  Real least_share = infinity;  ///< smallest mass of a node so far over the mass that its particles have in all

  /// A step of dt (s).
  void step(Real dt, Term without = Term::none)
  {
    const auto with = [&](Term term) { return term != without; };
    const Index nodes = mesh.node_count();
    NodeField<Real> M(nodes, 0), all(nodes, 0);
    NodeField<Vec<dim>> q(nodes, Vec<dim>::Zero()), f(q), a(q), new_q(q), v(q);
    const Hoop hoop(*this);
    const NodeField<char> touches = nodes_in_contact();

    // 1: particles to nodes
    for (const Particle<dim>& p : particles)
      for_each_corner(p, [&](Index i, Real N, const Vec<dim>& grad_N) {
        M[i] += N * p.mass;  // (1)
        q[i] += N * p.mass * p.v;
        all[i] += p.mass;
        if (with(Term::internal_force)) f[i] -= p.volume * matrix(p.stress) * grad_N;  // (2)
        if (around_axis() && with(Term::hoop_stress)) f[i][0] -= p.volume / p.x[0] * N * hoop.stress[p.cell];
        if (with(Term::gravity)) f[i] += N * p.mass * gravity;  // (3)
      });

    // 2, 3: momentum balance, with damping and supports
    for (Index i = 0; i < nodes; ++i) {
      if (M[i] == 0) continue;
      least_share = std::min(least_share, M[i] / all[i]);
      for (int d = 0; d < dim; ++d) {
        const bool holds = with(Term::supports) && (held[i] >> d & 1) != 0;
        const Real before = q[i][d] / M[i];
        const Real damping = with(Term::damping) && !touches[i] ? boundary::local_damping(damping_factor[i], f[i][d], before) : 0;
        a[i][d] = holds ? -before / dt : (f[i][d] + damping) / M[i];  // (4)
        v[i][d] = before + dt * a[i][d];                              // (6)
      }
    }

    // 4: contact, first time
    for (Index i = 0; i < nodes; ++i)
      if (touches[i] && with(Term::first_contact)) {
        const Vec<dim> corrected = corrected_at_contact(v[i], with(Term::friction));
        a[i] += (corrected - v[i]) / dt;  // (14)
        v[i] = corrected;
      }

    // 5 to 8: velocities of the particles, mapped to the nodes again; contact, second time
    for (Particle<dim>& p : particles) p.v += dt * at(p, a);  // (14)
    for (const Particle<dim>& p : particles) for_each_corner(p, [&](Index i, Real N, const Vec<dim>&) { new_q[i] += N * p.mass * p.v; });
    for (Index i = 0; i < nodes && with(Term::remapping); ++i) {
      if (M[i] == 0) continue;
      for (int d = 0; d < dim; ++d) v[i][d] = with(Term::supports) && (held[i] >> d & 1) != 0 ? 0 : new_q[i][d] / M[i];  // (15)-(18)
      if (touches[i] && with(Term::second_contact)) v[i] = corrected_at_contact(v[i], with(Term::friction));
    }

    // 9 to 11: positions, strains, stresses
    const CellField<Real> hoop_rate = hoop.rate(*this, v);
    for (Particle<dim>& p : particles) {
      Matrix<3> gradient = Matrix<3>::Zero();  // dv_a / dx_b
      for_each_corner(
          p, [&](Index i, Real, const Vec<dim>& grad_N) { gradient.template topLeftCorner<dim, dim>() += v[i] * grad_N.transpose(); });
      if (around_axis() && with(Term::hoop_strain)) gradient(2, 2) = hoop_rate[p.cell];
      p.x += dt * at(p, v);  // (19)
      const Matrix<3> strain = dt * (gradient + gradient.transpose()) / 2, rotation = dt * (gradient - gradient.transpose()) / 2;
      if (with(Term::rotation)) p.stress = tensor(stress_of(p) + rotation * stress_of(p) - stress_of(p) * rotation);  // Jaumann
      material::Increment<dim, Real> increment{.strain = tensor(strain), .dt = dt, .time = time};
      if (with(Term::law)) update(law, p.stress, increment, p.state.data());
      if (with(Term::volume)) p.volume = std::clamp(p.volume * (1 + strain.trace()), min_volume * p.mass, max_volume * p.mass);
      find_cell(p);
    }
    time += dt;
  }

private:
  bool around_axis() const { return mesh.metric == mesh::Metric::axisymmetric; }

  /// Calls act(i, N_i(x_p), grad N_i) for the nodes of the particle's cell.
  template <class Act>
  void for_each_corner(const Particle<dim>& p, const Act& act) const
  {
    const mesh::Shape<dim> shape = mesh.shape(p.cell);
    for (int k = 0; k <= dim; ++k) act(mesh.nodes[p.cell][k], shape.value(k, p.x), shape.gradient(k));
  }
  /// A nodal field at a particle, sum N_i(x_p) u_i.
  Vec<dim> at(const Particle<dim>& p, const NodeField<Vec<dim>>& u) const
  {
    Vec<dim> value = Vec<dim>::Zero();
    for_each_corner(p, [&](Index i, Real N, const Vec<dim>&) { value += N * u[i]; });
    return value;
  }
  NodeField<char> nodes_in_contact() const
  {
    NodeField<char> found(mesh.node_count(), false);
    for (const auto& nodes : mesh.nodes) {
      const auto is_inside = [&](Index i) { return rigid && rigid->normal.dot(mesh.position[i] - rigid->point) < 0; };
      if (std::any_of(nodes.begin(), nodes.end(), is_inside))
        for (const Index i : nodes) found[i] = true;
    }
    return found;
  }
  /// A velocity that does not enter the rigid body, and along it is reduced by friction (8)-(13).
  Vec<dim> corrected_at_contact(const Vec<dim>& v, bool with_friction) const
  {
    const Real approach = -rigid->normal.dot(v);
    if (approach <= 0) return v;
    const Vec<dim> slip = v + approach * rigid->normal;
    return std::max(Real(0), 1 - (with_friction ? rigid->friction : 0) * approach / slip.norm()) * slip;
  }
  void find_cell(Particle<dim>& p) const
  {
    const auto contains = [&](Index cell) {
      const mesh::Shape<dim> shape = mesh.shape(cell);
      Real least = 1;
      for (int k = 0; k <= dim; ++k) least = std::min(least, shape.value(k, p.x));
      return least >= 0;
    };
    if (contains(p.cell)) return;
    for (p.cell = 0; !contains(p.cell); ++p.cell)
      if (p.cell + 1 == mesh.cell_count()) throw std::logic_error("a particle has left the mesh");
  }

  /// Around an axis the particles of a cell have one hoop stress and one rate of hoop strain: the means over their volume of their stress and
  /// of v_r / r, which has no bound at single particles near the axis.
  struct Hoop {
    CellField<Real> volume, stress;

    explicit Hoop(const SlowStep& body) : volume(body.mesh.cell_count(), 0), stress(volume)
    {
      for (const Particle<dim>& p : body.particles) volume[p.cell] += p.volume;
      for (const Particle<dim>& p : body.particles) stress[p.cell] += p.volume * p.stress[2] / volume[p.cell];
    }
    CellField<Real> rate(const SlowStep& body, const NodeField<Vec<dim>>& v) const
    {
      CellField<Real> mean(volume.size(), 0);
      for (const Particle<dim>& p : body.particles) mean[p.cell] += p.volume * body.at(p, v)[0] / p.x[0] / volume[p.cell];
      return mean;
    }
  };

  static Matrix<3> stress_of(const Particle<dim>& p)
  {
    Matrix<3> full = Matrix<3>::Zero();
    for (int k = 0; k < 3; ++k) full(k, k) = p.stress[k];
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) full(a, b) = p.stress[tensor_index(a, b)];
    return full;
  }
  static Matrix<dim> matrix(const SymTensor<dim>& s)
  {
    Matrix<dim> full;
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) full(a, b) = s[tensor_index(a, b)];
    return full;
  }
  static SymTensor<dim> tensor(const Matrix<3>& full)
  {
    SymTensor<dim> s;
    for (int k = 0; k < 3; ++k) s[k] = full(k, k);
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b < dim; ++b) s[tensor_index(a, b)] = full(a, b);
    return s;
  }
};

}  // namespace berm::reference
