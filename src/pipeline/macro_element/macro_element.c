/* SPDX-License-Identifier: BSD-3-Clause */
/* The macro-element of a pipe on the seabed. What it is, and its units and signs: macro_element.h. */
#include "macro_element.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A number with its derivatives by the displacement of the step. */
typedef struct {
  double v, d[3];
} number;

/* What the state holds, in its order. */
typedef struct {
  number at, R, left_at, left_R;
} side_numbers;
typedef struct {
  number x, u, w, u_p, w_p, disturbed, mobilised;
  side_numbers side[2];
  number T, H, V;
} numbers;

/* An attempt to find the plastic displacement: A = |du_p|, B = dw_p, and what they leave of both conditions, with derivatives. */
typedef struct {
  double sign, H, V, w_p, disturbed, mobilised; /* of the elastic trial, H along sign */
  double flow_zero;                             /* v without vertical flow */
  double contact;                               /* 1; less where the pipe is lifted off */
  int lifted;
  double top; /* maximum of s^b1 (1 - s)^b2 */
} trial;
typedef struct {
  double v, m_h, m_v, dm_h, dm_v, zero_h, zero_v; /* flow at v, its derivatives by v and by the flow's zero */
} flow;
typedef struct {
  double g, g_B, g_v, g_w; /* vertical: V - k_v B - v V0 */
  double r, r_A, r_B, r_v, r_w, r_disturbed, r_mobilised, r_contact; /* horizontal: H - k_h A - resistance */
} misfit;

/* Closer to the tip the direction of flow is taken as straight down: the jump is less than what an increment may leave. */
static const double increment_over_D = 0.004, least_w_over_D = 0.01, least_V0 = 1e-3, near_tip = 1e-14;
/* Over D, and over k_v D: less is none. */
static const double least_slid = 1e-12, least_friction = 1e-14;
#define LARGEST_FLOW_ZERO 0.95
enum { max_iterations = 200 };

static double larger(double a, double b)
{
  return a > b ? a : b;
}

static double smaller(double a, double b)
{
  return a < b ? a : b;
}

static number constant(double v)
{
  number a = {0, {0, 0, 0}};
  a.v = v;
  return a;
}

/* a + f b */
static number sum(number a, double f, number b)
{
  int k;
  a.v += f * b.v;
  for (k = 0; k < 3; ++k) a.d[k] += f * b.d[k];
  return a;
}

/* V0 and its slope at a plastic embedment. */
static double backbone(const berm_macro_element_parameters* p, double w_p, double* slope)
{
  const int n = p->backbone_points;
  const double first = n > 0 ? p->backbone_w[0] : least_w_over_D * p->diameter;
  if (w_p < first) {
    const double V = n > 0 ? p->backbone_V[0] : p->backbone_factor * pow(least_w_over_D, p->backbone_power);
    *slope = w_p > least_V0 * first ? V / first : 0;
    return V * larger(w_p / first, least_V0);
  }
  if (n > 0) {
    int k = 1;
    if (n == 1) {
      *slope = 0;
      return p->backbone_V[0];
    }
    while (k + 1 < n && w_p >= p->backbone_w[k]) ++k;
    *slope = (p->backbone_V[k] - p->backbone_V[k - 1]) / (p->backbone_w[k] - p->backbone_w[k - 1]);
    return p->backbone_V[k - 1] + *slope * (w_p - p->backbone_w[k - 1]);
  }
  const double V = p->backbone_factor * pow(w_p / p->diameter, p->backbone_power);
  *slope = V * p->backbone_power / w_p;
  return V;
}

/* The largest s^b1 (1 - s)^b2. */
static double top_of(const berm_macro_element_parameters* p)
{
  const double s = p->surface_b1 / (p->surface_b1 + p->surface_b2);
  return pow(s, p->surface_b1) * pow(1 - s, p->surface_b2);
}

/* y(v) and its slope. */
static double shape(const berm_macro_element_parameters* p, double top, double v, double* slope)
{
  const double s = smaller(larger((v + p->surface_beta) / (1 + p->surface_beta), near_tip), 1 - near_tip);
  const double y = pow(s, p->surface_b1) * pow(1 - s, p->surface_b2) / top;
  *slope = y * (p->surface_b1 / s - p->surface_b2 / (1 - s)) / (1 + p->surface_beta);
  return y;
}

static flow flow_at(const berm_macro_element_parameters* p, double zero, double v)
{
  flow f;
  const double c = p->flow_slope, N = c * (v - zero), one = larger(1 - v, near_tip), root = sqrt(one), Q = one + N * N, q = sqrt(Q);
  const double Q_v = 2 * N * c - 1;
  f.v = v;
  f.m_h = v < 1 ? root / q : 0;
  f.m_v = v < 1 ? N / q : 1;
  f.dm_h = -(0.5 / root + root * Q_v / (2 * Q)) / q;
  f.dm_v = (c - N * Q_v / (2 * Q)) / q;
  f.zero_h = root * N * c / (Q * q);
  f.zero_v = -c * one / (Q * q);
  return f;
}

/* What is left of both conditions after plastic displacements A and B at v. */
static misfit misfit_of(const berm_macro_element_parameters* p, const trial* t, double A, double B, double v)
{
  misfit m;
  double dV0, dy;
  const double V0 = backbone(p, t->w_p + B, &dV0), y = shape(p, t->top, v, &dy);
  const double depth = larger(t->w_p, least_w_over_D * p->diameter), fresh = larger(B, 0), left = depth / (depth + fresh);
  const double disturbed = (t->disturbed + A) * left;
  const double faded = (1 - p->residual_ratio) * exp(-disturbed / p->softening_length), soft = p->residual_ratio + faded;
  const double dsoft = -faded / p->softening_length;
  const double x = 1 + A / p->mobilisation_length, mobilised = (t->mobilised * t->sign + x - 1) / x;
  const double dmobilised = (1 - t->mobilised * t->sign) / (p->mobilisation_length * x * x);
  const double part = p->first_yield + (1 - p->first_yield) * mobilised, all = p->peak_ratio * t->contact * y * V0;
  const double deeper = p->peak_ratio * t->contact * y * dV0 * soft * part;
  m.g = t->V - p->vertical_stiffness * B - v * V0;
  m.g_B = -p->vertical_stiffness - v * dV0;
  m.g_v = -V0;
  m.g_w = -v * dV0;
  m.r = t->H - p->horizontal_stiffness * A - all * soft * part;
  m.r_A = -p->horizontal_stiffness - all * (dsoft * left * part + soft * (1 - p->first_yield) * dmobilised);
  m.r_B = -deeper + (B > 0 ? all * part * dsoft * disturbed / (depth + fresh) : 0);
  m.r_v = -p->peak_ratio * t->contact * V0 * dy * soft * part;
  m.r_w = -deeper;
  if (t->w_p > least_w_over_D * p->diameter) m.r_w -= all * part * dsoft * (t->disturbed + A) * fresh / ((depth + fresh) * (depth + fresh));
  m.r_disturbed = -all * part * dsoft * left;
  m.r_mobilised = -all * soft * (1 - p->first_yield) * t->sign / x;
  m.r_contact = t->contact > 0 ? -all * soft * part / t->contact : -p->peak_ratio * y * V0 * soft * part;
  return m;
}

/* B where the vertical condition holds at this v. */
static double sunk_at(const berm_macro_element_parameters* p, const trial* t, double v)
{
  double low = -1e3 * p->diameter, high = 1e3 * p->diameter, B = 0;
  int k;
  for (k = 0; k < max_iterations; ++k) {
    double slope;
    const double g = t->V - p->vertical_stiffness * B - v * backbone(p, t->w_p + B, &slope);
    double next = B + g / (p->vertical_stiffness + v * slope);
    if (g > 0) low = B;
    else high = B;
    if (fabs(next - B) <= 1e-16 * p->diameter) return next;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    B = next;
  }
  return B;
}

/* v between parting and the tip where the vertical condition holds for a flow of length L, looked for from v on. */
static double v_of(const berm_macro_element_parameters* p, const trial* t, double L, double v)
{
  double low = -p->uplift_ratio, high = 1;
  int k;
  v = smaller(larger(v, low), high);
  for (k = 0; k < max_iterations; ++k) {
    const flow f = flow_at(p, t->flow_zero, v);
    double dV0, next;
    const double V0 = backbone(p, t->w_p + L * f.m_v, &dV0), g = t->V - p->vertical_stiffness * L * f.m_v - v * V0;
    next = v + g / (V0 + (p->vertical_stiffness + v * dV0) * L * f.dm_v);
    if (g > 0) low = v;
    else high = v;
    if (fabs(next - v) <= 2e-16) return v; /* also where it is an end of what is left */
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    v = next;
  }
  return v;
}

/* A point of the return path: a flow of length L. */
typedef enum { ON_SURFACE, AT_TIP, PARTING, LIFTED } return_kind;
typedef struct {
  return_kind kind;
  double L;
  flow f;
  double A, B, slope; /* |du_p|, dw_p, and of the horizontal misfit by L */
  misfit m;
} attempt;

static attempt attempt_at(const berm_macro_element_parameters* p, const trial* t, double L, double v)
{
  const flow sideways = {0, 1, 0, 0, 0, 0, 0}, lowest = flow_at(p, t->flow_zero, -p->uplift_ratio);
  attempt a;
  double slope;
  const double left = t->V - p->vertical_stiffness * L * lowest.m_v + p->uplift_ratio * backbone(p, t->w_p + L * lowest.m_v, &slope);
  a.kind = t->lifted ? LIFTED : left <= 0 ? PARTING : ON_SURFACE;
  a.L = L;
  a.f = t->lifted ? sideways : left <= 0 ? lowest : flow_at(p, t->flow_zero, v_of(p, t, L, v));
  a.A = L * a.f.m_h;
  a.B = a.kind == PARTING ? sunk_at(p, t, -p->uplift_ratio) : L * a.f.m_v;
  a.m = misfit_of(p, t, a.A, a.B, t->lifted ? -p->uplift_ratio : a.f.v);
  a.slope = a.m.r_A * a.f.m_h;
  if (a.kind == ON_SURFACE) {
    const double g_v = a.m.g_B * L * a.f.dm_v + a.m.g_v, r_v = a.m.r_A * L * a.f.dm_h + a.m.r_B * L * a.f.dm_v + a.m.r_v;
    a.slope += a.m.r_B * a.f.m_v - r_v * a.m.g_B * a.f.m_v / g_v;
  }
  return a;
}

/* The flow that brings the trial back to the surface; whether there is one. */
static int return_to_surface(const berm_macro_element_parameters* p, const trial* t, attempt* a)
{
  const double scale = p->horizontal_stiffness * p->diameter;
  double slope, high;
  const double V0 = backbone(p, t->w_p, &slope);
  double low = !t->lifted && t->V > V0 ? sunk_at(p, t, 1) : 0;
  int k;
  *a = attempt_at(p, t, low, t->V / V0);
  if (a->m.r <= 0) {
    a->kind = AT_TIP;
    return 1;
  }
  high = low + larger(t->H / p->horizontal_stiffness, 1e-12 * p->diameter);
  for (k = 0; k < max_iterations && (*a = attempt_at(p, t, high, a->f.v)).m.r > 0; ++k) {
    low = high;
    high *= 2;
  }
  for (k = 0; k < max_iterations && fabs(a->m.r) > 1e-15 * scale && high - low > 1e-16 * high; ++k) {
    double next = a->L - a->m.r / a->slope;
    if (a->m.r > 0) low = a->L;
    else high = a->L;
    if (!(next > low && next < high) || k % 8 == 7) next = 0.5 * (low + high);
    *a = attempt_at(p, t, next, a->f.v);
  }
  return fabs(a->m.r) <= 1e-9 * scale;
}

/* Its derivatives, from those of the trial's H (along its sign), V, w_p and so on. */
static void derive_flow(const attempt* a, double H, double V, double w_p, double disturbed, double mobilised, double contact, double zero, double* A,
                        double* B)
{
  const misfit* m = &a->m;
  const flow* f = &a->f;
  const double L = a->L;
  double r = H + m->r_w * w_p + m->r_disturbed * disturbed + m->r_mobilised * mobilised + m->r_contact * contact, g = V + m->g_w * w_p;
  *B = a->kind == LIFTED ? 0 : -g / m->g_B;
  *A = a->kind == AT_TIP ? 0 : -(r + m->r_B * *B) / m->r_A;
  if (a->kind == ON_SURFACE) {
    const double g_L = m->g_B * f->m_v, g_v = m->g_B * L * f->dm_v + m->g_v;
    const double r_L = m->r_A * f->m_h + m->r_B * f->m_v, r_v = m->r_A * L * f->dm_h + m->r_B * L * f->dm_v + m->r_v;
    const double det = g_L * r_v - g_v * r_L;
    double dL, dv;
    g += m->g_B * L * f->zero_v * zero;
    r += (m->r_A * L * f->zero_h + m->r_B * L * f->zero_v) * zero;
    dL = (g_v * r - r_v * g) / det;
    dv = (r_L * g - g_L * r) / det;
    *A = f->m_h * dL + L * (f->dm_h * dv + f->zero_h * zero);
    *B = f->m_v * dL + L * (f->dm_v * dv + f->zero_v * zero);
  }
}

/* Takes the plastic displacements A and B, with their derivatives, into the state. */
static void take_flow(const berm_macro_element_parameters* p, numbers* s, double sign, number A, number B)
{
  const double least = least_w_over_D * p->diameter, l = p->mobilisation_length, x = 1 + A.v / l;
  const number depth = s->w_p.v > least ? s->w_p : constant(least), fresh = B.v > 0 ? B : constant(0);
  const double all = depth.v + fresh.v, D = s->disturbed.v + A.v, m = s->mobilised.v;
  number disturbed, mobilised;
  int k;
  disturbed.v = D * depth.v / all;
  mobilised.v = (m + sign * A.v / l) / x;
  for (k = 0; k < 3; ++k) {
    disturbed.d[k] = (s->disturbed.d[k] + A.d[k]) * depth.v / all + D * (depth.d[k] * fresh.v - depth.v * fresh.d[k]) / (all * all);
    mobilised.d[k] = s->mobilised.d[k] / x + (sign - m) * A.d[k] / (l * x * x);
  }
  s->disturbed = disturbed;
  s->mobilised = mobilised;
  s->u_p = sum(s->u_p, sign, A);
  s->w_p = sum(s->w_p, 1, B);
}

/* H of the yield surface, s->V and how far the pipe slid across, after s->u and s->w have moved; returns an error. */
static int move_surface(const berm_macro_element_parameters* p, numbers* s, double top, number* H, number* slid)
{
  const double kv = p->vertical_stiffness, kh = p->horizontal_stiffness, least = least_w_over_D * p->diameter;
  double dV0, center, v;
  const double V0 = backbone(p, s->w_p.v, &dV0), parting = -p->uplift_ratio * V0;
  number H_trial = sum(s->u, -1, s->u_p), V_trial = sum(s->w, -1, s->w_p), zero = constant(p->flow_zero), contact = constant(1);
  trial t = {1, 0, 0, s->w_p.v, s->disturbed.v, 0, 0, 1, 0, top};
  int k;
  H_trial = sum(constant(0), kh, H_trial);
  V_trial = sum(constant(0), kv, V_trial);
  t.V = V_trial.v;
  t.lifted = t.V < parting;
  if (t.lifted) {
    const double depth = larger(s->w_p.v, least), gap = (parting - t.V) / kv;
    contact.v = larger(0, 1 - gap / depth);
    for (k = 0; k < 3 && contact.v > 0; ++k)
      contact.d[k] = (V_trial.d[k] + p->uplift_ratio * dV0 * s->w_p.d[k]) / (kv * depth) + (s->w_p.v > least ? gap / (depth * depth) * s->w_p.d[k] : 0);
  }
  *slid = constant(0);
  t.contact = contact.v;
  /* The middle of what is elastic, which earlier motion has moved, decides on the sign. */
  v = t.lifted ? -p->uplift_ratio : smaller(t.V / V0, 1);
  center = -misfit_of(p, &t, 0, 0, v).r / p->first_yield * (1 - p->first_yield) * s->mobilised.v;
  t.sign = (t.V >= V0 ? H_trial.v : H_trial.v - center) < 0 ? -1 : 1;
  t.H = t.sign * H_trial.v;
  t.mobilised = s->mobilised.v;
  if (t.sign * s->H.v > 0) {
    const double ratio = t.sign * s->H.v / V0;
    zero.v += p->flow_climb * ratio;
    for (k = 0; k < 3; ++k) zero.d[k] = p->flow_climb * (t.sign * s->H.d[k] - ratio * dV0 * s->w_p.d[k]) / V0;
  }
  if (zero.v > LARGEST_FLOW_ZERO) zero = constant(LARGEST_FLOW_ZERO);
  t.flow_zero = zero.v;
  if (t.V > V0 || misfit_of(p, &t, 0, 0, v).r > 0) {
    attempt a;
    number A, B;
    if (!return_to_surface(p, &t, &a)) return BERM_MACRO_ELEMENT_NO_SOLUTION;
    A.v = a.A;
    B.v = a.B;
    for (k = 0; k < 3; ++k)
      derive_flow(&a, t.sign * H_trial.d[k], V_trial.d[k], s->w_p.d[k], s->disturbed.d[k], s->mobilised.d[k], contact.d[k], zero.d[k], &A.d[k], &B.d[k]);
    take_flow(p, s, t.sign, A, B);
    H_trial = sum(H_trial, -t.sign * kh, A);
    V_trial = sum(V_trial, -kv, B);
    *slid = A;
  }
  *H = H_trial;
  s->V = V_trial;
  if (t.lifted) {
    s->V.v = parting * contact.v;
    for (k = 0; k < 3; ++k) s->V.d[k] = parting * contact.d[k] - p->uplift_ratio * dV0 * s->w_p.d[k] * contact.v;
  }
  return BERM_MACRO_ELEMENT_OK;
}

/* Force of the soil ahead on the side of this sign, after the pipe has moved to position x along it at embedment w. */
static number move_berm(const berm_macro_element_parameters* p, side_numbers* b, number x, number w)
{
  const double k_h = p->horizontal_stiffness, per_length = 1 / p->berm_length, ramp = p->berm_reach / 2;
  number force, e;
  int k;
  if (b->left_R.v > 0 && x.v >= b->left_at.v - ramp) { /* it is reached, and moves on with the pipe */
    b->R = sum(b->R, 1, b->left_R);
    b->at = sum(b->at, -1 / k_h, b->left_R);
    b->left_R = constant(0);
  }
  e = sum(x, -1, b->at);
  if (e.v <= 0) { /* out of touch */
    if (b->R.v > 0 && -e.v > p->berm_reach) {
      if (!(b->left_R.v > 0)) {
        b->left_at = sum(b->at, 1 / k_h, b->R);
        b->left_R = b->R;
      }
      b->R = constant(0);
    }
    if (!(b->R.v > 0)) b->at = x;
    e = constant(0);
  } else if (k_h * e.v > b->R.v) { /* it grows */
    const number depth = w.v > 0 ? w : constant(0);
    const double a = k_h * per_length, c = k_h * e.v - b->R.v, f = k_h + p->berm_rate * depth.v - k_h * e.v * per_length;
    const double root = sqrt(f * f + 4 * a * c);
    number moved;
    moved.v = 2 * c / (f + root);
    for (k = 0; k < 3; ++k)
      moved.d[k] = (k_h * e.d[k] - b->R.d[k] - (p->berm_rate * depth.d[k] - a * e.d[k]) * moved.v) / root;
    e = sum(e, -1, moved);
    b->at = sum(b->at, 1, moved);
    b->R = sum(constant(0), k_h, e);
  }
  force = sum(constant(0), k_h, e);
  if (b->left_R.v > 0) {
    const double part = (x.v - b->left_at.v + p->berm_reach) / ramp;
    if (part > 0)
      for (k = 0; k < 3; ++k) force.d[k] += part * b->left_R.d[k] + b->left_R.v / ramp * (x.d[k] - b->left_at.d[k]);
    force.v += larger(part, 0) * b->left_R.v;
  }
  return force;
}

/* zeta: the normal force around the contact divided by V. */
static number wedging(double diameter, number w)
{
  const double z = smaller(larger(w.v / diameter, 0), 0.5);
  double zeta = 1 + 2 * z / 3, slope = w.v > 0 && z < 0.5 ? 2 / (3 * diameter) : 0; /* its beginning */
  number result;
  int k;
  if (z > 1e-6) {
    const double b = acos(1 - 2 * z), sin_b = sin(b), cos_b = 1 - 2 * z, around = b + sin_b * cos_b;
    zeta = 2 * sin_b / around;
    if (z < 0.5) slope = 4 * cos_b * (b - sin_b * cos_b) / (around * around * sin_b * diameter);
  }
  result.v = zeta;
  for (k = 0; k < 3; ++k) result.d[k] = slope * w.d[k];
  return result;
}

/* T after the pipe has moved along by dx while it slid across by A. With c = |T + R dx/l|/R and a sliding B along, c - B/l = B/sqrt(A^2 + B^2) = T/R. */
static number move_along(const berm_macro_element_parameters* p, const numbers* s, number dx, number A)
{
  const number zeta = wedging(p->diameter, s->w);
  const double l = p->axial_mobilisation, R = p->axial_friction * zeta.v * s->V.v, tried = R > 0 ? s->T.v / R + dx.v / l : 0;
  const double sign = tried < 0 ? -1 : 1, c = fabs(tried);
  double part = smaller(c, 1), part_c = c < 1, part_A = 0; /* |T|/R and its derivatives */
  number T = constant(0);
  int k;
  if (!(R > least_friction * p->vertical_stiffness * p->diameter)) return T;
  if (A.v > least_slid * p->diameter) {
    double B = larger(0, l * (c - 1)), rest = 0, h = A.v;
    for (k = 0; k < max_iterations; ++k) { /* the left side is steeper than its slope says: B comes from below */
      double next;
      h = hypot(A.v, B);
      rest = (A.v / h) * (A.v / h) / h;
      next = B + (c - B / l - B / h) / (1 / l + rest);
      if (!(next > B)) break;
      B = next;
    }
    part = B / h;
    part_c = rest / (1 / l + rest);
    part_A = -part * A.v / (h * h) / (1 + l * rest);
  }
  T.v = sign * R * part;
  for (k = 0; k < 3; ++k) {
    const double R_k = p->axial_friction * (zeta.d[k] * s->V.v + zeta.v * s->V.d[k]);
    const double c_k = sign * (s->T.d[k] / R - s->T.v / R * R_k / R + dx.d[k] / l);
    T.d[k] = sign * (R_k * part + R * (part_c * c_k + part_A * A.d[k]));
  }
  return T;
}

static int is_number(double x)
{
  return x - x == 0;
}

const char* berm_macro_element_error(int code)
{
  static const char* const words[] = {"no error", "a pointer is null", "parameters or state are of another version", "a parameter is out of its range",
                                      "a displacement or force is not a number or too large", "an increment did not converge"};
  return code >= 0 && code < (int)(sizeof words / sizeof *words) ? words[code] : "unknown error";
}

#define MEMBER(name, unit, least, most) {#name, unit, offsetof(berm_macro_element_parameters, name), least, most}
#define ABOVE_0 DBL_MIN
#define BELOW_1 (1 - DBL_EPSILON)
#define ANY DBL_MAX
const berm_macro_element_member berm_macro_element_members[BERM_MACRO_ELEMENT_MEMBERS] = {
    MEMBER(diameter, "m", ABOVE_0, ANY),
    MEMBER(vertical_stiffness, "N/m^2", ABOVE_0, ANY), MEMBER(horizontal_stiffness, "N/m^2", ABOVE_0, ANY),
    MEMBER(backbone_factor, "N/m", 0, ANY),            MEMBER(backbone_power, "1", 0, ANY),
    MEMBER(peak_ratio, "1", ABOVE_0, ANY),             MEMBER(surface_beta, "1", 0, ANY),
    MEMBER(surface_b1, "1", ABOVE_0, BELOW_1),         MEMBER(surface_b2, "1", ABOVE_0, BELOW_1),
    MEMBER(uplift_ratio, "1", 0, ANY),                 MEMBER(flow_slope, "1", ABOVE_0, ANY),
    MEMBER(flow_zero, "1", -ANY, LARGEST_FLOW_ZERO),   MEMBER(flow_climb, "1", 0, ANY),
    MEMBER(first_yield, "1", 0.5, 1),                  MEMBER(mobilisation_length, "m", ABOVE_0, ANY),
    MEMBER(residual_ratio, "1", ABOVE_0, 1),           MEMBER(softening_length, "m", ABOVE_0, ANY),
    MEMBER(berm_rate, "N/m^3", 0, ANY),                MEMBER(berm_length, "m", ABOVE_0, ANY),
    MEMBER(berm_reach, "m", ABOVE_0, ANY),
    MEMBER(axial_friction, "1", 0, ANY),               MEMBER(axial_mobilisation, "m", ABOVE_0, ANY),
};

/* No pipe and no soil comes near to these, and their products are numbers. */
#define SMALLEST 1e-15
#define LARGEST 1e18

/* The name of the first parameter that makes no sense, or null. */
static const char* wrong_parameter(const berm_macro_element_parameters* p)
{
  const int n = p->backbone_points;
  int k;
  for (k = 0; k < BERM_MACRO_ELEMENT_MEMBERS; ++k) {
    const berm_macro_element_member* m = &berm_macro_element_members[k];
    double value;
    memcpy(&value, (const char*)p + m->offset, sizeof value);
    if (!(value >= m->least && value <= m->most)) return m->name;
    if (fabs(value) > LARGEST || (m->least == ABOVE_0 && value < SMALLEST)) return m->name;
  }
  if (p->uplift_ratio > p->surface_beta) return "uplift_ratio";
  if (n < 0 || n > BERM_MACRO_ELEMENT_MAX_POINTS) return "backbone_points";
  if (n == 0 && !(p->backbone_factor > 0)) return "backbone_factor";
  if (n == 0 && !(p->backbone_power > 0)) return "backbone_power";
  for (k = 0; k < n; ++k) {
    if (!(p->backbone_w[k] > (k > 0 ? p->backbone_w[k - 1] : 0) && is_number(p->backbone_w[k]))) return "backbone_w";
    if (!(p->backbone_V[k] >= (k > 0 ? p->backbone_V[k - 1] : SMALLEST) && is_number(p->backbone_V[k]))) return "backbone_V";
  }
  return NULL;
}

int berm_macro_element_check(const berm_macro_element_parameters* p, const char** wrong)
{
  if (p == NULL) return BERM_MACRO_ELEMENT_NULL;
  if (p->version != BERM_MACRO_ELEMENT_VERSION) return BERM_MACRO_ELEMENT_OTHER_VERSION;
  const char* name = wrong_parameter(p);
  if (name == NULL) return BERM_MACRO_ELEMENT_OK;
  if (wrong != NULL) *wrong = name;
  return BERM_MACRO_ELEMENT_PARAMETERS;
}

int berm_macro_element_start(const berm_macro_element_parameters* p, const double displacement[3], double V, berm_macro_element_state* state)
{
  const int error = berm_macro_element_check(p, NULL);
  if (error != BERM_MACRO_ELEMENT_OK) return error;
  if (displacement == NULL || state == NULL) return BERM_MACRO_ELEMENT_NULL;
  const double w = displacement[2], w_p = larger(w - V / p->vertical_stiffness, 0);
  double slope;
  if (!is_number(displacement[0]) || !is_number(displacement[1]) || !is_number(w) ||
      !(V >= 0 && V <= (1 + 1e-9) * backbone(p, w_p, &slope)) || (w < 0 && V > 0))
    return BERM_MACRO_ELEMENT_INPUT;
  memset(state, 0, sizeof *state);
  state->version = BERM_MACRO_ELEMENT_VERSION;
  state->x = displacement[0];
  state->u = state->u_p = state->berm[0].at = displacement[1];
  state->berm[1].at = -displacement[1];
  state->w = w;
  state->w_p = w_p;
  state->V = V;
  return BERM_MACRO_ELEMENT_OK;
}

/* Between the numbers of a state and those with derivatives, which are zero at first. */
#define FIRST offsetof(berm_macro_element_state, x)
static numbers numbers_of(const berm_macro_element_state* state)
{
  numbers s;
  size_t k;
  memset(&s, 0, sizeof s);
  for (k = 0; k < BERM_MACRO_ELEMENT_NUMBERS; ++k) memcpy((char*)&s + k * sizeof(number), (const char*)state + FIRST + k * sizeof(double), sizeof(double));
  return s;
}

static void take_numbers(const numbers* s, berm_macro_element_state* state)
{
  size_t k;
  state->version = BERM_MACRO_ELEMENT_VERSION;
  for (k = 0; k < BERM_MACRO_ELEMENT_NUMBERS; ++k) memcpy((char*)state + FIRST + k * sizeof(double), (const char*)s + k * sizeof(number), sizeof(double));
}

/* Surface, berms and friction, after s->u and s->w have moved, and the pipe along by dx; returns an error. */
static int move_by_increment(const berm_macro_element_parameters* p, numbers* s, double top, number dx)
{
  number H, slid;
  int side;
  if (move_surface(p, s, top, &H, &slid) != BERM_MACRO_ELEMENT_OK) return BERM_MACRO_ELEMENT_NO_SOLUTION;
  for (side = 0; side < 2; ++side) {
    const double sign = side == 0 ? 1 : -1;
    H = sum(H, sign, move_berm(p, &s->side[side], sum(constant(0), sign, s->u), s->w));
  }
  s->H = H;
  s->T = move_along(p, s, dx, slid);
  return BERM_MACRO_ELEMENT_OK;
}

int berm_macro_element_step(const berm_macro_element_parameters* p, const berm_macro_element_state* before, const double displacement[3],
                            berm_macro_element_state* after, double F[3], double K[3][3])
{
  const int error = berm_macro_element_check(p, NULL);
  int k;
  if (error != BERM_MACRO_ELEMENT_OK) return error;
  if (before == NULL || displacement == NULL || after == NULL || F == NULL) return BERM_MACRO_ELEMENT_NULL;
  if (before->version != BERM_MACRO_ELEMENT_VERSION) return BERM_MACRO_ELEMENT_OTHER_VERSION;
  const double top = top_of(p), by[3] = {displacement[0] - before->x, displacement[1] - before->u, displacement[2] - before->w};
  for (k = 0; k < 3; ++k)
    if (!(fabs(by[k]) <= 100 * p->diameter)) return BERM_MACRO_ELEMENT_INPUT;
  const int n = (int)larger(ceil(larger(fabs(by[1]), fabs(by[2])) / (increment_over_D * p->diameter)), 1);
  numbers s = numbers_of(before);
  for (k = 1; k <= n; ++k) {
    const double part = (double)k / n;
    number dx = constant(by[0] / n);
    dx.d[0] = 1.0 / n;
    s.x.v = k == n ? displacement[0] : before->x + part * by[0];
    s.u.v = k == n ? displacement[1] : before->u + part * by[1];
    s.w.v = k == n ? displacement[2] : before->w + part * by[2];
    s.u.d[1] = s.w.d[2] = part;
    if (move_by_increment(p, &s, top, dx) != BERM_MACRO_ELEMENT_OK) return BERM_MACRO_ELEMENT_NO_SOLUTION;
  }
  if (!is_number(s.T.v + s.H.v + s.V.v)) return BERM_MACRO_ELEMENT_INPUT;
  for (k = 0; k < 3; ++k)
    if (!is_number(s.T.d[k] + s.H.d[k] + s.V.d[k])) return BERM_MACRO_ELEMENT_NO_SOLUTION;
  take_numbers(&s, after);
  for (k = 0; k < 3; ++k) {
    const number* force = k == 0 ? &s.T : k == 1 ? &s.H : &s.V;
    F[k] = force->v;
    if (K != NULL) memcpy(K[k], force->d, sizeof force->d);
  }
  return BERM_MACRO_ELEMENT_OK;
}

/* strtod obeys the locale that the program has set: it gets that one's decimal sign. */
const char* berm_macro_element_read_number(const char* text, double* value)
{
  const char* sign = localeconv()->decimal_point;
  const size_t blanks = strspn(text, " \t\r\n"), length = strcspn(text + blanks, " \t\r\n");
  const char *begin = text + blanks, *point = (const char*)memchr(begin, '.', length);
  const size_t before = point == NULL ? length : (size_t)(point - begin);
  char own[100], *end = own;
  if (length == 0 || length + strlen(sign) >= sizeof own || strspn(begin, "+-.0123456789eE") < length) return NULL;
  memset(own, 0, sizeof own);
  memcpy(own, begin, before);
  if (point != NULL) strncat(strcpy(own + before, sign), point + 1, length - before - 1);
  *value = strtod(own, &end);
  return *end == 0 ? begin + length : NULL;
}
