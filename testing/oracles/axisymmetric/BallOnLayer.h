// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate::oracle
{

/// An elastic layer on a rigid base that holds it, without end sideways: small strain.
struct Layer
{
  double young_Pa = 20e3;
  double poisson = 0.4;
  double thickness_m = 0.05;
};

/// A rigid ball without friction in it.
struct BallContact
{
  double radius_m = 0.0; ///< of the contact
  double depth_m = 0.0;
  double force_N = 0.0;
};

/// By the contact's radius. Lebedev & Ufliand's (1958) integral equation of the second kind, whose kernel is that of
/// Burmister's (1945) layer, by Gauss' points; the gap is the sphere's, not a paraboloid's.
[[nodiscard]] BallContact contactOfRadius(const Layer& layer, double ball_m, double contact_m);

/// By its depth.
[[nodiscard]] BallContact contactOfDepth(const Layer& layer, double ball_m, double depth_m);

/// How deep a rigid ball goes into a half space (Sneddon 1965), by the contact's radius.
[[nodiscard]] BallContact onHalfSpace(double young_Pa, double poisson, double ball_m, double contact_m);

} // namespace palpate::oracle
