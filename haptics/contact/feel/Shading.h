// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// The smooth normal where feature f is touched, on the side of `plane.n`. Where nothing smooth is known, `plane.n`
/// itself comes back: across edges sharper than 30 degrees, free edges, edges of more than two faces, vertices of more
/// than 128 faces, and where the two normals differ by more than 45 degrees.
///
/// Linear over a face between the normals at its corners. A corner's normal is the sum over the faces that are reached
/// from this one without crossing such an edge, with Max's weights (1999), which are exact for corners on a sphere.
/// `plane`: of f, unit normal and foot [W]. Bounded; real-time safe.
template<class View>
[[nodiscard]] Vec3 smoothNormal(const View& s, const ActiveFeature& f, const FeaturePlane& plane) noexcept;

/// Where the shaded god-object goes next.
struct ShadedStep
{
  FrictionState motion = FrictionState::None;
  bool touches = false;         ///< false: the touched planes do not hold the device back; nothing is shaded
  bool rests = true;            ///< it is where it belongs
  Vec3 target_W = Vec3::Zero(); ///< else: the device point that brings the unshaded god-object there
};

/// Force shading (Morgenbesser & Srinivasan 1996, Ruspini et al. 1997), under friction if there is any.
///
/// The device is projected onto the planes through the ball with the smooth normals, and from there onto the touched
/// planes themselves: there the frictionless shaded god-object would go, and proxy - device would be a sum of smooth
/// normals. Friction keeps or trails the ball from there as judgeFriction does. The target lies only half as deep as
/// its distance: a ball that is drawn from deep below an edge between facets leaps over the edge, and would leap back.
/// Repeated, on a sphere of radius R pressed by d, each round leaves about d / R of the way.
/// `slipping`: an earlier round of the same tick has decided that the ball slips.
/// Re-linearises the features of `state`; real-time safe.
template<SceneView AnyScene>
[[nodiscard]] ShadedStep judgeShading(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, bool slipping, GodObjectState& state) noexcept;

} // namespace palpate
