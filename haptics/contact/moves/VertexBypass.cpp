// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/moves/VertexBypass.h"

#include "haptics/contact/planes/FeatureGeometry.h"

namespace palpate
{
namespace
{

template<class View>
class WayMaker
{
public:
  WayMaker(const View& s, const VertexFan& fan, std::uint32_t v, const BypassScale& scale) noexcept
    : s_(s), fan_(fan), v_(v), scale_(scale)
  {
  }

  /// From the first face of the fan to its face number `last`.
  void addFacesTo(int last) noexcept
  {
    std::array<int, VertexFan::capacity> chain;
    int count = 0;
    for (int i = last; i >= 0; i = this->fan_.faces[static_cast<std::size_t>(i)].before)
    {
      chain[static_cast<std::size_t>(count++)] = i;
    }
    this->way_.add(this->overFace(this->fan_[0]));
    for (int k = count - 2; k >= 0; --k)
    {
      const VertexFan::Face& to = this->fan_.faces[static_cast<std::size_t>(chain[static_cast<std::size_t>(k)])];
      const ActiveFeature& from = this->fan_[to.before];
      if (!isValley(from, to.face, to.over))
      {
        this->way_.add(this->beyondEdge(from, to.over));
        this->way_.add(this->beyondEdge(to.face, to.over));
      }
      this->way_.add(this->overFace(to.face));
    }
  }

  void addDescent(const Descent& descent, const Vec3& q) noexcept
  {
    const ActiveFeature &f = descent.faces[0], &g = descent.faces[1];
    if (descent.far == SurfaceData::none)
    {
      const Vec3 n = this->normal(f);
      this->way_.add(this->at((q - q.dot(n) * n).normalized(), n));
    }
    else if (descent.count == 2 && isValley(f, g, descent.far))
    {
      const Vec3 n = this->normal(f), m = this->normal(g);
      this->way_.add(this->at(this->along(descent.far), (n + m) / (1.0 + n.dot(m)))); // as high above both
    }
    else
    {
      this->way_.add(this->beyondEdge(f, descent.far));
    }
  }

  [[nodiscard]] const VertexBypass& way() const noexcept { return this->way_; }

private:
  [[nodiscard]] Vec3 normal(const ActiveFeature& f) const noexcept { return f.side * this->s_.face(f.a).normal_W; }
  [[nodiscard]] Vec3 along(std::uint32_t far) const noexcept { return edgeLine(this->s_, this->v_, far).unit; }

  [[nodiscard]] Vec3 at(const Vec3& direction, const Vec3& up) const noexcept
  {
    return this->s_.vertex(this->v_) + this->scale_.reach_u * direction + this->scale_.height_u * up;
  }

  /// In the middle between the face's edges at the vertex.
  [[nodiscard]] Vec3 overFace(const ActiveFeature& f) const noexcept
  {
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t corner : this->s_.corners(f.a))
    {
      middle += corner != this->v_ ? this->along(corner) : Vec3::Zero();
    }
    return this->at(middle.normalized(), this->normal(f));
  }

  /// True if face g rises above the plane of face f, with which it has the edge to `far`.
  [[nodiscard]] bool isValley(const ActiveFeature& f, const ActiveFeature& g, std::uint32_t far) const noexcept
  {
    return f.a != g.a && this->outward(g, far).dot(this->normal(f)) < 0.0;
  }

  /// Beyond the edge over which face f is left, as high as over the face.
  [[nodiscard]] Vec3 beyondEdge(const ActiveFeature& f, std::uint32_t far) const noexcept
  {
    return this->at(this->along(far), this->normal(f) + this->outward(f, far));
  }

  [[nodiscard]] Vec3 outward(const ActiveFeature& f, std::uint32_t far) const noexcept
  {
    const auto& t = this->s_.corners(f.a);
    int k = 0;
    while (t[k] != this->s_.opposite(f.a, this->v_, far))
    {
      ++k;
    }
    return outwardNormal(this->s_, f.a, (k + 1) % 3); // the edge after the corner that is not on it
  }

  const View& s_;
  const VertexFan& fan_;
  std::uint32_t v_;
  BypassScale scale_;
  VertexBypass way_;
};

} // namespace

template<class View>
VertexBypass bypassVertex(const View& s, const VertexFan& fan, std::uint32_t v, const Descent& descent, const Vec3& q,
  const BypassScale& scale) noexcept
{
  WayMaker maker(s, fan, v, scale);
  maker.addFacesTo(descent.at);
  maker.addDescent(descent, q);
  return maker.way();
}

template VertexBypass bypassVertex(
  const SurfaceData&, const VertexFan&, std::uint32_t, const Descent&, const Vec3&, const BypassScale&) noexcept;
template VertexBypass bypassVertex(
  const PosedSurface&, const VertexFan&, std::uint32_t, const Descent&, const Vec3&, const BypassScale&) noexcept;

} // namespace palpate
