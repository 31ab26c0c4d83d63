#include "motion/piece_list.hpp"

#include <algorithm>

#include "motion/pieces.hpp"
#include "motion/rotation_forms.hpp"

namespace taut::internal {
namespace {

/// From so many on it matters how much room there is that nothing is in.
constexpr std::size_t many_pieces = 256;
/// Most motions of one piece have no more.
constexpr std::size_t few_numbers = 8;

}  // namespace

void PieceList::Packed::add(const MotionPiece& piece) {
  if (numbers.empty()) numbers.reserve(few_numbers);
  Place place;
  place.until = piece.until;
  place.first = numbers.size();
  const auto put = [this](const Coefficients& c) {
    numbers.insert(numbers.end(), c.begin(), c.end());
    return static_cast<std::uint8_t>(c.size());
  };
  place.x = put(piece.x);
  place.y = put(piece.y);
  place.form = static_cast<std::uint8_t>(piece.rotation.index());
  std::uint8_t* count = &place.a;
  for_each_polynomial(piece.rotation, [&](const Coefficients& c) {
    *count = put(c);
    count = &place.b;
  });
  if (const JointFollower* const follower = followed_joint(piece)) {
    put({static_cast<double>(joints.size())});
    joints.push_back(*follower);
  }
  if (piece.pivot != Point{}) {
    place.pivot = true;
    put({piece.pivot.x, piece.pivot.y});
  }
  if (piece.origin != 0) {
    place.origin = true;
    put({piece.origin});
  }
  place.orbit = put(piece.orbit.angle);
  if (place.orbit > 0) put({piece.orbit.centre.x, piece.orbit.centre.y});
  places.push_back(place);
}

void PieceList::Packed::trim() {
  if (places.size() < many_pieces) return;
  places.shrink_to_fit();
  numbers.shrink_to_fit();
}

PieceList::PieceList(const std::vector<MotionPiece>& pieces) {
  const auto packed = std::make_shared<Packed>();
  packed->places.reserve(pieces.size());
  for (const MotionPiece& piece : pieces) packed->add(piece);
  packed->trim();
  packed_ = packed;
}

PieceList PieceList::between(const Motion& motion, double start, double end, int exponent) {
  const auto packed = std::make_shared<Packed>();
  for_each_piece_between(motion, start, end,
                         [&](MotionPiece&& piece) { packed->add(scaled(std::move(piece), exponent)); });
  packed->places.back().until = std::numeric_limits<double>::infinity();
  packed->trim();
  return PieceList(packed);
}

PieceList PieceList::after(MotionPiece piece, double t) const {
  const auto packed = std::make_shared<Packed>();
  piece.until = t;
  packed->add(piece);
  for (std::size_t k = 0; k < size(); ++k) packed->add((*this)[k]);
  packed->trim();
  return PieceList(packed);
}

MotionPiece PieceList::operator[](std::size_t k) const {
  const Place& place = packed_->places[k];
  const double* next = packed_->numbers.data() + place.first;
  const auto take = [&next](std::uint8_t count) {
    Coefficients c(next, next + count);
    next += count;
    return c;
  };
  const auto take_point = [&next] {
    const Point p{next[0], next[1]};
    next += 2;
    return p;
  };
  MotionPiece piece;
  piece.until = place.until;
  piece.x = take(place.x);
  piece.y = take(place.y);
  if (place.form == form_index<JointFollower>) {
    piece.rotation = packed_->joints[static_cast<std::size_t>(take(1)[0])];
  } else {
    piece.rotation = rotation_of_form(place.form);
    const std::uint8_t* count = &place.a;
    for_each_polynomial(piece.rotation, [&](Coefficients& c) {
      c = take(*count);
      count = &place.b;
    });
  }
  if (place.pivot) piece.pivot = take_point();
  if (place.origin) piece.origin = *next++;
  piece.orbit.angle = take(place.orbit);
  if (place.orbit > 0) piece.orbit.centre = take_point();
  return piece;
}

std::span<const double> PieceList::way(std::size_t k, bool of_y) const {
  const Place& place = packed_->places[k];
  const std::span<const double> all(packed_->numbers.data() + place.first, std::size_t{place.x} + place.y);
  return of_y ? all.subspan(place.x) : all.first(place.x);
}

std::size_t PieceList::number_at(double t) const {
  const auto& places = packed_->places;
  const auto later = [](double time, const Place& place) { return time < place.until; };
  const auto found = std::upper_bound(places.begin(), places.end(), t, later);
  return static_cast<std::size_t>((found == places.end() ? found - 1 : found) - places.begin());
}

std::optional<PieceList::Rates> PieceList::last_rates(double end) const {
  std::size_t k = size() - 1;
  while (k > 0 && until(k - 1) >= end) --k;
  const Place& place = packed_->places[k];
  const bool angle = place.form == form_index<AngleRotation>;
  if (place.x > 1 || place.y > 1 || place.orbit > 2 || place.form == form_index<JointFollower>) return std::nullopt;
  if (place.a > (angle ? 2 : 1) || place.b > 1) return std::nullopt;
  Rates rates{k > 0 ? until(k - 1) : -std::numeric_limits<double>::infinity(), 0, 0};
  if (angle && place.a == 2)
    rates.turn = packed_->numbers[static_cast<std::size_t>(place.first) + place.x + place.y + 1];
  // The orbit's angle comes last, before its centre.
  const std::size_t before_orbit = static_cast<std::size_t>(place.first) + place.x + place.y + place.a + place.b +
                                   (place.pivot ? 2u : 0u) + (place.origin ? 1u : 0u);
  if (place.orbit == 2) rates.orbit = packed_->numbers[before_orbit + 1];
  return rates;
}

bool PieceList::follows_joint() const { return !empty() && packed_->places.front().form == form_index<JointFollower>; }

bool PieceList::same_at(std::size_t a, std::size_t b) const { return a == b || same_motion((*this)[a], (*this)[b]); }

bool PieceList::rests() const {
  if (empty()) return true;
  // Whatever its pivot is: nothing turns about it.
  return std::all_of(packed_->places.begin(), packed_->places.end(), [](const Place& place) {
    return place.x == 0 && place.y == 0 && place.form == form_index<NoRotation> && place.orbit == 0;
  });
}

bool same_pieces(const PieceList& a, const PieceList& b) {
  if (a.packed_ == b.packed_) return true;
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a.until(k) != b.until(k) || !same_motion(a[k], b[k])) return false;
  }
  return true;
}

std::size_t count_common(const MotionChain& a, const MotionChain& b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), same_pieces).first;
  return static_cast<std::size_t>(end - a.begin());
}

MotionChain without_first(const MotionChain& chain, std::size_t count) {
  static const PieceList rest({MotionPiece{}});
  if (count == chain.size()) return {rest};
  return {chain.begin() + static_cast<std::ptrdiff_t>(count), chain.end()};
}

std::vector<MotionPiece> pieces_at(const MotionChain& motions, double t) {
  std::vector<MotionPiece> chain;
  for (const PieceList& pieces : motions) chain.push_back(pieces.at(t));
  if (chain.empty()) chain.push_back(MotionPiece{});
  return chain;
}

}  // namespace taut::internal
