// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/found/PlacesByArea.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace palpate
{
namespace
{

constexpr int mostRounds = 30;
/// Of the depth that forces push out: so far patches leave places apart that touch.
constexpr double uneven = 0.1;
/// Of the side of a part: a centre that moves by less stays.
constexpr double stays = 1e-3;

/// The places that touch, in parts around centres.
class Parts
{
public:
  Parts(const std::vector<const NearPlace*>& places, std::size_t most, double least_u) : places_(places)
  {
    for (const NearPlace* place : places)
    {
      this->area_u2_ += place->area_u2;
    }
    const double fit = least_u > 0.0 ? this->area_u2_ / (least_u * least_u) : 0.0;
    this->count_ = std::min({ most, places.size(), std::max<std::size_t>(1, static_cast<std::size_t>(fit)) });
    this->side_u_ = std::max(least_u, std::sqrt(this->area_u2_ / static_cast<double>(this->count_)));
  }

  [[nodiscard]] double side_u() const { return this->side_u_; }

  /// The place of each part that is nearest to its middle.
  void divide(const FoundContacts& before, PlacesByArea& found)
  {
    this->begin(before);
    for (int left = mostRounds; left > 0 && this->moveCentres(); --left)
    {
    }
    std::vector<std::vector<const NearPlace*>> parts(this->centres_.size());
    for (const NearPlace* place : this->places_)
    {
      parts[this->nearest(*place)].push_back(place);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const auto away = [&](const NearPlace* place) { return this->away2(*place, this->centres_[i]); };
      if (!parts[i].empty())
      {
        found.chosen.places.push_back(**std::ranges::min_element(parts[i], {}, away));
        found.parts.push_back(std::move(parts[i]));
      }
    }
  }

private:
  struct Centre
  {
    Vec3 x_W = Vec3::Zero();
    Vec3 normal_B = Vec3::Zero();
  };

  /// Places that press in another direction are as far as if they were beyond the part.
  [[nodiscard]] double away2(const NearPlace& place, const Centre& centre) const
  {
    const double turned =
      std::max(0.0, 1.0 - place.contact.normal_B.dot(centre.normal_B)) / (1.0 - FoundContact::alike);
    return (place.contact.place_B.x_W - centre.x_W).squaredNorm() + turned * this->side_u_ * this->side_u_;
  }

  [[nodiscard]] static Centre centreAt(const NearPlace& place)
  {
    return { place.contact.place_B.x_W, place.contact.normal_B };
  }

  [[nodiscard]] std::size_t nearest(const NearPlace& place) const
  {
    const auto away = [&](const Centre& centre) { return this->away2(place, centre); };
    return static_cast<std::size_t>(std::ranges::min_element(this->centres_, {}, away) - this->centres_.begin());
  }

  /// Those that were chosen before, then each time the place that is furthest from all.
  void begin(const FoundContacts& before)
  {
    std::vector<double> away2(this->places_.size(), std::numeric_limits<double>::infinity());
    const auto add = [&](std::size_t i)
    {
      this->centres_.push_back(centreAt(*this->places_[i]));
      for (std::size_t k = 0; k < away2.size(); ++k)
      {
        away2[k] = std::min(away2[k], this->away2(*this->places_[k], this->centres_.back()));
      }
    };
    for (int i = 0; i < before.count && this->centres_.size() < this->count_; ++i)
    {
      const auto same = [&](const NearPlace* place)
      { return place->contact.name == before.contacts[static_cast<std::size_t>(i)].name; };
      const auto at = std::ranges::find_if(this->places_, same);
      if (at != this->places_.end())
      {
        add(static_cast<std::size_t>(at - this->places_.begin()));
      }
    }
    while (this->centres_.size() < this->count_)
    {
      add(static_cast<std::size_t>(std::ranges::max_element(away2) - away2.begin()));
    }
  }

  [[nodiscard]] bool moveCentres()
  {
    std::vector<Centre> sums(this->centres_.size());
    std::vector<double> areas_u2(this->centres_.size(), 0.0);
    for (const NearPlace* place : this->places_)
    {
      const std::size_t at = this->nearest(*place);
      areas_u2[at] += place->area_u2;
      sums[at].x_W += place->area_u2 * place->contact.place_B.x_W;
      sums[at].normal_B += place->area_u2 * place->contact.normal_B;
    }
    double moved_u = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      if (areas_u2[i] > 0.0)
      {
        const Centre to{ sums[i].x_W / areas_u2[i], sums[i].normal_B.normalized() };
        moved_u = std::max(moved_u, (to.x_W - this->centres_[i].x_W).norm());
        this->centres_[i] = to;
      }
    }
    return moved_u > stays * this->side_u_;
  }

  const std::vector<const NearPlace*>& places_;
  std::vector<Centre> centres_;
  double area_u2_ = 0.0;
  double side_u_ = 0.0;
  std::size_t count_ = 0;
};

} // namespace

PlacesByArea choosePlacesByArea(
  const std::vector<NearPlace>& near, PlaceRoom room, double least_u, double touches_u, const FoundContacts& before)
{
  const auto touches = [touches_u](const NearPlace& place)
  { return place.gap_u <= std::max(touches_u, -uneven * place.free_u); };
  std::vector<const NearPlace*> touching;
  for (const NearPlace& place : near)
  {
    if (touches(place))
    {
      touching.push_back(&place);
    }
  }
  PlacesByArea found;
  ChosenPlaces& chosen = found.chosen;
  chosen.apart_u = least_u;
  if (!touching.empty() && room.most > 0)
  {
    Parts parts(touching, room.most, least_u);
    parts.divide(before, found);
    chosen.apart_u = parts.side_u() / sideOfPlace;
  }
  std::vector<NearPlace> others;
  for (const NearPlace& place : near)
  {
    if (!touches(place) && standsApart(place, chosen.places, chosen.apart_u))
    {
      others.push_back(place);
    }
  }
  const auto left = [&](std::size_t of) { return of - std::min(of, chosen.places.size()); };
  const ChosenPlaces beside =
    choosePlaces(others, { left(room.most), left(room.apart) }, chosen.apart_u, touches_u, before);
  chosen.places.insert(chosen.places.end(), beside.places.begin(), beside.places.end());
  return found;
}

} // namespace palpate
