// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "haptics/core/Types.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// The points within reach of a centre; a negative reach: none.
struct Reach
{
  Vec3 centre_W = Vec3::Zero();
  double reach_u = -1.0;

  [[nodiscard]] bool covers(const Reach& other) const noexcept
  {
    return this->reach_u > 0.0 && (other.centre_W - this->centre_W).norm() + other.reach_u <= this->reach_u;
  }
};

/// A disc in W that holds a face now, or a ball without a normal. In a list for all the rest of a way it is a ball that
/// goes straight with its face, by `normal_W` until the end, in the unit of the list.
struct PlacedDisc
{
  Vec3 origin_W, centre_W, normal_W;
  double radius_u, extent_u; ///< the disc, and the largest coordinate of its leaf's discs relative to origin_W
};

/// All faces within reach of a centre with their discs. Sweeps within that reach look at the list instead of the tree,
/// which never changes a result, only the cost. Fixed memory, no allocation; a copy copies the used part alone.
class FaceList
{
public:
  static constexpr int capacity = 512; ///< faces, 18 kB with their discs

  struct Face
  {
    std::uint32_t surface;
    std::uint32_t triangle;
  };
  /// In which frame the discs are given: relative to centre_W, in a unit of which 1 u is perUnit. No coordinate of a
  /// disc is larger than extent of it.
  struct Frame
  {
    Vec3 centre_W = Vec3::Zero();
    double perUnit = 1.0;
    double extent = 0.0;
  };

  FaceList() noexcept {} // NOLINT(modernize-use-equals-default): the faces are not to be set to zero
  FaceList(const FaceList& other) noexcept { *this = other; }
  FaceList& operator=(const FaceList& other) noexcept
  {
    this->reach_ = other.reach_;
    this->frame_ = other.frame_;
    this->count_ = other.count_;
    std::copy_n(other.faces_.begin(), other.count_, this->faces_.begin());
    std::copy_n(other.discs_.begin(), other.quads(), this->discs_.begin());
    return *this;
  }
  ~FaceList() = default;

  [[nodiscard]] const Reach& reach() const noexcept { return this->reach_; }
  [[nodiscard]] const Frame& frame() const noexcept { return this->frame_; }
  [[nodiscard]] int count() const noexcept { return this->count_; }
  [[nodiscard]] int quads() const noexcept { return (this->count_ + 3) / 4; }
  [[nodiscard]] const Face& face(int i) const noexcept { return this->faces_[static_cast<std::size_t>(i)]; }
  /// Discs of faces 4 quad .. 4 quad + 3, or balls on their way.
  [[nodiscard]] const DiscQuad& discs(int quad) const noexcept { return this->discs_[static_cast<std::size_t>(quad)]; }

  /// Which of these four are faces: bit k for face 4 quad + k.
  [[nodiscard]] int lanesOf(int quad) const noexcept { return (1 << std::min(4, this->count_ - 4 * quad)) - 1; }

  void clear() noexcept
  {
    this->reach_ = {};
    this->count_ = 0;
  }
  /// Begins a list of the faces within that reach, which the caller adds.
  void begin(const Reach& reach) noexcept
  {
    this->reach_ = reach;
    this->frame_ = { reach.centre_W, 1.0 / reach.reach_u, 0.0 };
    this->count_ = 0;
  }
  /// Begins a list of faces of another one, which are taken over with take().
  void beginFrom(const FaceList& other, const Reach& reach) noexcept
  {
    this->reach_ = reach;
    this->frame_ = other.frame_;
    this->count_ = 0;
  }
  void take(const FaceList& other, int i) noexcept
  {
    const DiscQuad& from = other.discs(i / 4);
    this->put({ from.cx[i % 4], from.cy[i % 4], from.cz[i % 4] }, { from.nx[i % 4], from.ny[i % 4], from.nz[i % 4] },
      from.radius[i % 4], other.face(i));
  }
  /// There must be room.
  void add(const PlacedDisc& disc, const Face& face) noexcept
  {
    const Vec3 centre = this->frame_.perUnit * (disc.centre_W - this->frame_.centre_W);
    // Discs of one leaf lie within its extent, also where it has been turned.
    const Vec3 origin = disc.origin_W - this->frame_.centre_W;
    this->frame_.extent =
      std::max(this->frame_.extent, this->frame_.perUnit * (disc.extent_u + origin.cwiseAbs().maxCoeff()));
    this->put(centre.cast<float>(), disc.normal_W.cast<float>(),
      static_cast<float>(this->frame_.perUnit * disc.radius_u), face);
  }

private:
  void put(const Eigen::Vector3f& centre, const Eigen::Vector3f& normal, float radius, const Face& face) noexcept
  {
    DiscQuad& to = this->discs_[static_cast<std::size_t>(this->count_) / 4];
    const auto at = static_cast<std::size_t>(this->count_) % 4;
    to.cx[at] = centre.x();
    to.cy[at] = centre.y();
    to.cz[at] = centre.z();
    to.nx[at] = normal.x();
    to.ny[at] = normal.y();
    to.nz[at] = normal.z();
    to.radius[at] = radius;
    this->faces_[static_cast<std::size_t>(this->count_++)] = face;
  }

  Reach reach_;
  Frame frame_;
  int count_ = 0;
  std::array<Face, capacity> faces_;
  std::array<DiscQuad, capacity / 4> discs_;
};

/// The faces around a ball that are kept from one tick to the next. They are of one content. While surfaces bend, `far`
/// holds for the rest of their way: a ball of it goes straight with its face.
struct FacesAround
{
  std::uint64_t content = 0; ///< Scene::contentHash(); 0: nothing is kept
  double share = 1.0;        ///< of the way of its surfaces, where `near` is
  double since = 1.0;        ///< from this share on `far` holds
  bool skips = true;         ///< no list is made in this tick, which pays for new content or has made one
  double room_u = 0.0;       ///< how much further `far` reaches than the next tick needs
  double mostRoom_u = std::numeric_limits<double>::infinity(); ///< for which the faces are few enough
  bool isOwed = false; ///< a list was made that has to prove its use, whether `far` still has it or not
  int served = 0;      ///< ticks for which that list had all that was needed
  int useless = 0;     ///< lists that did not fit or served too few ticks, one after the other
  int pause = 0;       ///< so many ticks go by before the next try
  FaceList far;        ///< within reach of the ticks to come
  FaceList near;       ///< of the last sweeps, mostly a part of `far`

  /// True if `far` has balls that go with faces on their way.
  [[nodiscard]] bool bends() const noexcept { return this->since < 1.0; }
  /// Drops lists of another content or place.
  void openFor(std::uint64_t other, double otherShare) noexcept
  {
    const bool sameContent = this->content == other;
    if (!sameContent || otherShare < this->since)
    {
      this->far.clear();
    }
    if (!sameContent || this->share != otherShare)
    {
      this->near.clear();
    }
    this->skips = this->skips || !sameContent;
    this->content = other;
    this->share = otherShare;
  }
};

} // namespace palpate
