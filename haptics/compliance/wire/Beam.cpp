// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/wire/Beam.h"

#include <algorithm>
#include <cmath>

#include "haptics/compliance/wire/ArcSeries.h"
#include "haptics/core/CrossMatrix.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

/// Motions that a beam feels: of the second node against the first, and turns of both.
using Felt = Eigen::Matrix<double, 9, 1>;
using FeltSquare = Eigen::Matrix<double, 9, 9>;

Mat3 bothWays(const Vec3& a, const Vec3& b) noexcept
{
  return a * b.transpose() + b * a.transpose();
}

/// An end of the beam: its own direction beside that of the chord.
struct BeamEnd
{
  Mat3 axes;         ///< of the beam as this node leads it: x along, y and z across
  Vec3 along;        ///< its x axis
  Vec3 off;          ///< the part of that across the chord
  Vec3 turned;       ///< along x chord
  double cosine = 1; ///< of the angle between them
  ArcSeries arc;
  Vec3 twistBy; ///< rate of twist about the chord by turns of the node
  Vec3 carried; ///< and by motions of the chord's direction, with opposite sign
};

struct BeamShape
{
  double length = 0.0;
  Vec3 chord;
  Mat3 across; ///< projection
  std::array<BeamEnd, 2> ends;
};

BeamEnd endOf(const Quat& q, const Vec3& chord) noexcept
{
  BeamEnd end;
  end.axes = q.toRotationMatrix();
  end.along = end.axes.col(0);
  const double s = 0.5 * (end.along - chord).squaredNorm();
  end.cosine = 1.0 - s;
  end.off = end.along - end.cosine * chord;
  end.turned = end.along.cross(chord);
  end.arc = arcOf(s);
  const double share = 1.0 / std::max(1.0 + end.cosine, 1e-9);
  end.twistBy = share * (end.along + chord);
  end.carried = share * end.turned;
  return end;
}

BeamShape shapeOf(const WireBeam& beam, const Pose& first_W, const Pose& second_W) noexcept
{
  BeamShape shape;
  const Vec3 d = second_W.p - first_W.p;
  shape.length = std::max(d.norm(), 1e-9 * beam.length_u);
  shape.chord = d / shape.length;
  shape.across = Mat3::Identity() - shape.chord * shape.chord.transpose();
  shape.ends = { endOf(first_W.q * beam.first, shape.chord), endOf(second_W.q * beam.second, shape.chord) };
  return shape;
}

/// How far the second end is twisted about the chord against the first, both carried to the chord on the shortest way.
double twistOf(const BeamShape& shape) noexcept
{
  const auto carried = [&shape](const BeamEnd& end) -> Vec3
  { return end.axes.col(1) - end.axes.col(1).dot(shape.chord) * end.twistBy; };
  const Vec3 a = carried(shape.ends[0]), b = carried(shape.ends[1]);
  const double half = std::max(0.5 * (a + b).norm(), 1e-9); // the cosine of half the angle
  return rotationVector(Quat(half, 0.5 * shape.chord.dot(a.cross(b)) / half, 0.0, 0.0)).x();
}

/// Derivatives of the length, of the cosines between each end and the chord and of both ends, and of the twist.
struct Gradients
{
  Felt length = Felt::Zero();
  Felt cosine[2] = { Felt::Zero(), Felt::Zero() };
  Felt between = Felt::Zero();
  Felt twist = Felt::Zero();
};

Gradients gradientsOf(const BeamShape& shape) noexcept
{
  const BeamEnd& a = shape.ends[0];
  const BeamEnd& b = shape.ends[1];
  Gradients g;
  g.length.head<3>() = shape.chord;
  for (int i = 0; i < 2; ++i)
  {
    g.cosine[i].head<3>() = shape.ends[i].off / shape.length;
    g.cosine[i].segment<3>(3 + 3 * i) = shape.ends[i].turned;
  }
  g.between.segment<3>(3) = a.along.cross(b.along);
  g.between.segment<3>(6) = -g.between.segment<3>(3);
  g.twist.head<3>() = (a.carried - b.carried) / shape.length;
  g.twist.segment<3>(3) = -a.twistBy;
  g.twist.segment<3>(6) = b.twistBy;
  return g;
}

/// The energy of bending by the three cosines: its value, first and second derivatives.
struct Bending
{
  double energy = 0.0;
  double byCosine[2] = { 0.0, 0.0 };
  double byBetween = 0.0;
  double twice[2] = { 0.0, 0.0 }; ///< by one cosine
  double byBoth = 0.0;
  double mixed[2] = { 0.0, 0.0 }; ///< by a cosine and that between both ends
};

Bending bendingOf(const WireBeam& beam, const BeamShape& shape) noexcept
{
  const BeamEnd& a = shape.ends[0];
  const BeamEnd& b = shape.ends[1];
  const double slender = 12.0 * beam.section.bend_Nu2 / (beam.section.shear_N * beam.length_u * beam.length_u);
  const double base = beam.section.bend_Nu2 / (beam.length_u * (1.0 + slender));
  const double own = 0.5 * (4.0 + slender) * base;
  const double shared = (2.0 - slender) * base;
  const double together = a.off.dot(b.off);
  Bending e;
  e.energy = own * (a.arc.squared + b.arc.squared) + shared * a.arc.ratio * b.arc.ratio * together;
  e.byBetween = shared * a.arc.ratio * b.arc.ratio;
  for (int i = 0; i < 2; ++i)
  {
    const BeamEnd& one = shape.ends[i];
    const BeamEnd& other = shape.ends[1 - i];
    e.byCosine[i] =
      -2.0 * own * one.arc.ratio + shared * other.arc.ratio * (one.arc.first * together - one.arc.ratio * other.cosine);
    e.twice[i] = -2.0 * own * one.arc.first +
                 shared * other.arc.ratio * (one.arc.second * together - 2.0 * one.arc.first * other.cosine);
    e.mixed[i] = shared * one.arc.first * other.arc.ratio;
  }
  e.byBoth = shared * (a.arc.first * b.arc.first * together - a.arc.first * b.arc.ratio * a.cosine -
                        a.arc.ratio * b.arc.first * b.cosine - a.arc.ratio * b.arc.ratio);
  return e;
}

/// Products of derivatives of the cosines, length and twist.
FeltSquare products(const WireBeam& beam, const Gradients& g, const Bending& e) noexcept
{
  const double stretch = beam.section.stretch_N / beam.length_u;
  const double twist = beam.section.twist_Nu2 / beam.length_u;
  Eigen::Matrix<double, 9, 5> left, right;
  left << g.length, g.cosine[0], g.cosine[1], g.between, g.twist;
  right.col(0) = stretch * g.length;
  right.col(1) = e.twice[0] * g.cosine[0] + e.byBoth * g.cosine[1] + e.mixed[0] * g.between;
  right.col(2) = e.byBoth * g.cosine[0] + e.twice[1] * g.cosine[1] + e.mixed[1] * g.between;
  right.col(3) = e.mixed[0] * g.cosine[0] + e.mixed[1] * g.cosine[1];
  right.col(4) = twist * g.twist;
  return left.lazyProduct(right.transpose());
}

/// Adds a block and its mirror image.
void addBeside(FeltSquare& k, int row, int column, const Mat3& block) noexcept
{
  k.block<3, 3>(row, column) += block;
  k.block<3, 3>(column, row) += block.transpose();
}

/// Second derivatives of the cosine between an end and the chord, and of the end's share in the twist.
void addBentEnd(const BeamShape& shape, int i, double byCosine, double byTwist, FeltSquare& k) noexcept
{
  const BeamEnd& end = shape.ends[i];
  const double inverse = 1.0 / shape.length;
  const int turn = 3 + 3 * i;
  const double share = byTwist / std::max(1.0 + end.cosine, 1e-9);
  const Mat3 along = crossMatrix(end.along);
  k.topLeftCorner<3, 3>() -=
    byCosine * inverse * inverse * (bothWays(end.off, shape.chord) + end.cosine * shape.across);
  k.topLeftCorner<3, 3>() +=
    inverse * inverse * (0.5 * share * bothWays(end.off, end.carried) + byTwist * bothWays(shape.chord, end.carried));
  Mat3 beside = -byCosine * inverse * shape.across * along;
  beside += share * inverse * (shape.across - end.off * end.twistBy.transpose());
  addBeside(k, 0, turn, beside);
  k.block<3, 3>(turn, turn) += byCosine * (0.5 * bothWays(shape.chord, end.along) - end.cosine * Mat3::Identity()) -
                               0.5 * byTwist * bothWays(end.twistBy, end.carried);
}

/// Second derivatives of the cosine between both ends.
void addBetween(const BeamShape& shape, double byBetween, FeltSquare& k) noexcept
{
  const Vec3& a = shape.ends[0].along;
  const Vec3& b = shape.ends[1].along;
  const double cosine = a.dot(b);
  const Mat3 own = byBetween * (0.5 * bothWays(a, b) - cosine * Mat3::Identity());
  k.block<3, 3>(3, 3) += own;
  k.block<3, 3>(6, 6) += own;
  addBeside(k, 3, 6, byBetween * (cosine * Mat3::Identity() - b * a.transpose()));
}

void spread(const Felt& gradient, const FeltSquare& k, BeamAnswer& answer) noexcept
{
  answer.gradient[0] << -gradient.head<3>(), gradient.segment<3>(3);
  answer.gradient[1] << gradient.head<3>(), gradient.segment<3>(6);
  const Mat3 apart = k.topLeftCorner<3, 3>();
  answer.firstFirst << apart, -k.block<3, 3>(0, 3), -k.block<3, 3>(3, 0), k.block<3, 3>(3, 3);
  answer.secondSecond << apart, k.block<3, 3>(0, 6), k.block<3, 3>(6, 0), k.block<3, 3>(6, 6);
  answer.firstSecond << -apart, -k.block<3, 3>(0, 6), k.block<3, 3>(3, 0), k.block<3, 3>(3, 6);
}

} // namespace

void bendBeam(const WireBeam& beam, const Pose& first_W, const Pose& second_W, BeamAnswer& answer) noexcept
{
  const BeamShape shape = shapeOf(beam, first_W, second_W);
  const Gradients g = gradientsOf(shape);
  const Bending e = bendingOf(beam, shape);
  const double longer_u = shape.length - beam.length_u;
  answer.tension_N = beam.section.stretch_N / beam.length_u * longer_u;
  answer.twist_rad = twistOf(shape);
  const double torque_Nu = beam.section.twist_Nu2 / beam.length_u * answer.twist_rad;
  answer.energy_Nu = e.energy + 0.5 * answer.tension_N * longer_u + 0.5 * torque_Nu * answer.twist_rad;
  const Felt gradient = answer.tension_N * g.length + e.byCosine[0] * g.cosine[0] + e.byCosine[1] * g.cosine[1] +
                        e.byBetween * g.between + torque_Nu * g.twist;
  FeltSquare k = products(beam, g, e);
  k.topLeftCorner<3, 3>() += answer.tension_N / shape.length * shape.across;
  addBentEnd(shape, 0, e.byCosine[0], -torque_Nu, k);
  addBentEnd(shape, 1, e.byCosine[1], torque_Nu, k);
  addBetween(shape, e.byBetween, k);
  spread(gradient, k, answer);
}

} // namespace palpate
