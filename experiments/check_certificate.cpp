// SPDX-License-Identifier: GPL-3.0-or-later
// check_certificate FILE... BALL SOCKET [--ball-part FILE...] [--socket-part FILE...]: whether certificates
// of `impinge certify` hold for these meshes (PLY or OBJ). A second checker, written from
// certificate_format.md alone, without anything of libcore. One line a certificate; exit code 0 if all hold,
// 1 if one does not, 2 for bad usage. All is decided in integers: corners relative to the centre, times a
// number that makes all of them whole. Nothing that decides is rounded but in `beside`, whose rounding keeps
// the order.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmpxx.h>

namespace {

using Integer = mpz_class;
using Fraction = mpq_class;
using Vec = std::array<Integer, 3>;
using Index = std::uint32_t;
using Face = std::array<Index, 3>;
using Faces = std::vector<Face>;
using Words = std::vector<std::string>;

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator*(const Integer& s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
Integer dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int orientation(const Vec& a, const Vec& b, const Vec& c) { return sgn(dot(a, cross(b, c))); }

// ---- files ----

Words words_of(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

Integer integer(const std::string& word) {
  const std::size_t minus = word.starts_with('-') ? 1 : 0;
  const bool digits = word.find_first_not_of("0123456789", minus) == std::string::npos;
  require(digits && word.size() > minus && word.size() <= 1000, "'" + word.substr(0, 50) + "' is no integer");
  return Integer(word, 10);
}

Fraction decimal(const std::string& word) {
  const auto end = std::min(word.find_first_of("eE"), word.size()), point = std::min(word.find('.'), end);
  std::string digits = word.substr(0, point), exponent = end < word.size() ? word.substr(end + 1) : "0";
  if (point < end) digits += word.substr(point + 1, end - point - 1);
  for (auto* text : {&digits, &exponent})
    if (text->starts_with('+') && !text->starts_with("+-")) text->erase(0, 1);
  const Integer power = integer(exponent) - (point < end ? end - point - 1 : 0);
  require(abs(power) <= 1000, "'" + word.substr(0, 50) + "' has too large an exponent");
  Integer ten;
  mpz_ui_pow_ui(ten.get_mpz_t(), 10, Integer(abs(power)).get_ui());
  return power < 0 ? Fraction(integer(digits)) / ten : Fraction(integer(digits) * ten);
}

Index count(const Fraction& number) {
  require(number.get_den() == 1 && number >= 0 && number <= 0x7fffffff, "a count or corner that can not be");
  return static_cast<Index>(number.get_num().get_ui());
}

struct Mesh {
  std::vector<std::array<Fraction, 3>> corners;
  Faces faces;
};

Mesh read_obj(std::istream& in) {
  static const std::set<std::string> beside{"vt", "vn", "vp", "g", "o", "s", "usemtl", "mtllib", "l", "p"};
  Mesh mesh;
  for (std::string line; std::getline(in, line);) {
    const Words words = words_of(line);
    if (words.empty() || words[0][0] == '#' || beside.contains(words[0])) continue;
    if (words[0] == "v" && words.size() >= 4 &&
        words.size() != 5) {  // a fourth number is a weight, more are colours
      mesh.corners.push_back({decimal(words[1]), decimal(words[2]), decimal(words[3])});
      continue;
    }
    require(words[0] == "f" && words.size() == 4,
            "a line '" + words[0].substr(0, 20) + "' that is no triangle");
    const auto corner = [&](std::size_t k) {
      return count(integer(words[k].substr(0, words[k].find('/'))) - 1);
    };
    mesh.faces.push_back({corner(1), corner(2), corner(3)});
  }
  return mesh;
}

/// The next number of a PLY file after its header.
Fraction next_number(std::istream& in, const std::string& type, const std::string& format) {
  static const Words types{"char", "uchar", "short", "ushort", "int",   "uint",   "float",   "double",
                           "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  const auto kind = (std::find(types.begin(), types.end(), type) - types.begin()) % 8;
  require(std::count(types.begin(), types.end(), type) == 1, "unknown type of a number");
  std::string word;
  if (format == "ascii") return in >> word, decimal(word);
  word.resize(kind < 6 ? std::size_t{1} << kind / 2 : kind == 6 ? 4 : 8);
  require(bool(in.read(word.data(), static_cast<std::streamsize>(word.size()))), "the file ends early");
  if (format == "binary_little_endian") std::reverse(word.begin(), word.end());
  std::uint64_t bits = kind % 2 == 0 && kind < 6 && word[0] < 0 ? ~std::uint64_t{0} : 0;
  for (const char byte : word) bits = bits << 8 | static_cast<unsigned char>(byte);
  if (kind < 6) return static_cast<double>(static_cast<std::int64_t>(bits));  // at most 32 bits
  const double value =
      kind == 7 ? std::bit_cast<double>(bits) : double{std::bit_cast<float>(static_cast<Index>(bits))};
  require(std::isfinite(value), "a number is not finite");
  return value;
}

Mesh read_ply(std::istream& in) {
  std::vector<Words>
      elements;  // name, number, and of each property: type of a list's length or "", type, name
  std::string line, format;
  while (std::getline(in, line) && words_of(line) != Words{"end_header"}) {
    const Words words = words_of(line + " .");
    if (words[0] == "format") format = words[1];
    if (words[0] == "element" && words.size() == 4) elements.push_back({words[1], words[2]});
    if (words[0] != "property" || elements.empty() || words.size() < 4) continue;
    const bool list = words.size() == 6 && words[1] == "list";
    elements.back().insert(elements.back().end(),
                           {list ? words[2] : "", words[words.size() - 3], words[words.size() - 2]});
  }
  require(in && (format == "ascii" || format == "binary_little_endian" || format == "binary_big_endian"),
          "no PLY");
  Mesh mesh;
  for (const Words& e : elements) {
    require(e.size() > 2 && e[0] != "tristrips", "an element without numbers, or of strips");
    for (Integer left = integer(e[1]); left > 0; --left) {
      std::vector<Fraction> corner, face;
      for (std::size_t p = 2; p < e.size(); p += 3) {
        const bool faces = e[0] == "face" && (e[p + 2] == "vertex_indices" || e[p + 2] == "vertex_index");
        const bool place = e[0] == "vertex" && (e[p + 2] == "x" || e[p + 2] == "y" || e[p + 2] == "z");
        const Index length = e[p].empty() ? 1 : count(next_number(in, e[p], format));
        require(length == 3 || !faces, "a face has not three corners");
        for (Index k = 0; k < length; ++k) {
          const Fraction value = next_number(in, e[p + 1], format);
          if (faces || place) (faces ? face : corner).push_back(value);
        }
      }
      require(corner.size() == (e[0] == "vertex" ? 3 : 0), "a vertex has not x, y and z");
      if (!corner.empty()) mesh.corners.push_back({corner[0], corner[1], corner[2]});
      if (face.size() == 3) mesh.faces.push_back({count(face[0]), count(face[1]), count(face[2])});
    }
  }
  return mesh;
}

// ---- bodies ----

struct File {
  Faces faces;
  bool closed = true;
};

struct Body {
  std::vector<Vec> corners;  ///< each once, times scale
  Integer scale = 1;
  std::vector<File> files;
  Faces faces;              ///< each once
  std::vector<Index> used;  ///< corners of faces, first one of each piece, then the others
  std::ptrdiff_t pieces = 0;
  std::vector<Vec> rest,
      moved;  ///< from the centre; times a number of both bodies' corners, another if moved
  std::vector<std::array<double, 3>> rounded;  ///< of moved
};

bool two_equal(const Face& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }

Faces once(const Faces& faces) {
  std::set<Face> seen;
  Faces kept;
  for (const Face& face : faces) {
    Face key = face;
    std::sort(key.begin(), key.end());
    if (seen.insert(key).second) kept.push_back(face);
  }
  return kept;
}

Body read_body(const Words& names) {
  std::vector<std::array<Fraction, 3>> all;
  Body body;
  for (const auto& name : names) try {
      std::ifstream in(name, std::ios::binary);
      const std::string kind = name.substr(std::min(name.rfind('.'), name.size()));
      require(kind == ".ply" || kind == ".PLY" || kind == ".obj" || kind == ".OBJ",
              "only .ply and .obj are read");
      if (!in) throw std::invalid_argument("cannot be read");
      Mesh mesh = kind == ".ply" || kind == ".PLY" ? read_ply(in) : read_obj(in);
      for (Face& f : mesh.faces)
        for (Index& v : f) {
          require(v < mesh.corners.size(), "a face has a corner that is not there");
          v += static_cast<Index>(all.size());
        }
      all.insert(all.end(), mesh.corners.begin(), mesh.corners.end());
      body.files.push_back({mesh.faces});
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(name + ": " + error.what());
    }
  for (const auto& x : all)
    for (const Fraction& value : x) body.scale = lcm(body.scale, value.get_den());
  std::vector<Vec> whole;
  const auto scaled = [&](const Fraction& value) {
    return Integer(body.scale / value.get_den() * value.get_num());
  };
  for (const auto& x : all) whole.push_back({scaled(x[0]), scaled(x[1]), scaled(x[2])});
  std::vector<Index> order(all.size()), number(all.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return whole[a] < whole[b]; });
  for (const Index v : order) {
    if (body.corners.empty() || body.corners.back() != whole[v]) body.corners.push_back(whole[v]);
    number[v] = static_cast<Index>(body.corners.size() - 1);
  }
  for (File& file : body.files) {
    for (Face& f : file.faces) f = {number[f[0]], number[f[1]], number[f[2]]};
    file.faces = once(file.faces);
    std::set<std::pair<Index, Index>> odd;  // edges
    for (const Face& f : file.faces)
      for (std::size_t k = 0; k < 3 && !two_equal(f); ++k)
        if (const auto edge = odd.insert(std::minmax({f[k], f[(k + 1) % 3]})); !edge.second)
          odd.erase(edge.first);
    file.closed = odd.empty();
    body.faces.insert(body.faces.end(), file.faces.begin(), file.faces.end());
  }
  body.faces = once(body.faces);
  std::vector<Index> up(body.corners.size());
  std::iota(up.begin(), up.end(), 0U);
  const auto root = [&](Index v) {
    while (up[v] != v) v = up[v] = up[up[v]];
    return v;
  };
  std::set<Index> used;
  for (const Face& f : body.faces) {
    for (const Index v : f) up[root(v)] = root(f[0]), used.insert(v);
  }
  body.used.assign(used.begin(), used.end());
  body.pieces = std::partition(body.used.begin(), body.used.end(), [&](Index v) { return root(v) == v; }) -
                body.used.begin();
  return body;
}

/// 1 if a ray from p that meets no edge crosses an odd number of the file's faces, -1 if an even one; 0 if p
/// is on a face or none of a hundred rays is so.
int parity(const Body& body, const File& file, const Vec& p) {
  const auto beside = [&, x = p[0].get_d(),
                       y = p[1].get_d()](const Face& f) {  // a ray along z; get_d() keeps the order
    const auto &a = body.rounded[f[0]], &b = body.rounded[f[1]], &c = body.rounded[f[2]];
    return std::max({a[0], b[0], c[0]}) < x || std::min({a[0], b[0], c[0]}) > x ||
           std::max({a[1], b[1], c[1]}) < y || std::min({a[1], b[1], c[1]}) > y;
  };
  std::mt19937 random(1);  // NOLINT(*-msc51-cpp): the same each time
  Vec along{0, 0, 1};
  for (int ray = 0; ray < 100; ++ray) {
    bool odd = false, edge = false;
    for (const Face& f : file.faces) {
      if (two_equal(f) || (ray == 0 && beside(f))) continue;
      const Vec a = body.moved[f[0]] - p, b = body.moved[f[1]] - p, c = body.moved[f[2]] - p;
      const auto s =
          std::minmax({orientation(along, a, b), orientation(along, b, c), orientation(along, c, a)});
      if (s.first < 0 && s.second > 0) continue;
      const int ahead = orientation(a, b, c);
      edge = s.first == 0 || s.second == 0 || ahead == 0;
      if (edge) break;
      odd ^= ahead == s.first;
    }
    if (!edge) return odd ? 1 : -1;
    for (Integer& number : along) number = static_cast<int>(random() % 4001) - 2000;
  }
  return 0;
}

/// Whether one of a body's first `corners` used corners is inside a closed file of the other.
bool one_inside(const Body& body, std::ptrdiff_t corners, const Body& other, bool bone_outside) {
  return std::any_of(body.used.begin(), body.used.begin() + corners, [&](Index v) {
    return std::any_of(other.files.begin(), other.files.end(), [&](const File& file) {
      const bool outside = bone_outside && &file == other.files.data();
      return file.closed && parity(other, file, body.moved[v]) == (outside ? -1 : 1);
    });
  });
}

/// Whether an edge of a face meets another face, and is not in its plane.
bool edge_meets(const Body& edges, const Face& of, const Body& faces, const Face& f) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec &p = edges.moved[of[k]], &q = edges.moved[of[(k + 1) % 3]], along = q - p;
    const Vec a = faces.moved[f[0]] - p, b = faces.moved[f[1]] - p, c = faces.moved[f[2]] - p;
    const int from = orientation(a, b, c), to = orientation(a - along, b - along, c - along);
    const auto s =
        std::minmax({orientation(along, a, b), orientation(along, b, c), orientation(along, c, a)});
    if (from * to <= 0 && from != to && (s.first >= 0 || s.second <= 0)) return true;
  }
  return false;
}

// ---- the motion and the tree ----

struct Quaternion {
  Integer w;
  Vec v;
};
Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
Integer norm(const Quaternion& q) { return q.w * q.w + dot(q.v, q.v); }
Quaternion inverse(const Quaternion& q) { return {q.w, Integer(-1) * q.v}; }
/// x in the rotation of q, times norm(q).
Vec turned(const Quaternion& q, const Vec& x) { return (q * Quaternion{0, x} * inverse(q)).v; }

struct HalfAngle {
  Integer c, s;
};
/// Sine and cosine of half the turn from a to b, times the same positive number.
Integer sine(const HalfAngle& a, const HalfAngle& b) { return a.c * b.s - a.s * b.c; }
Integer cosine(const HalfAngle& a, const HalfAngle& b) { return a.c * b.c + a.s * b.s; }

struct Plane {
  Vec n;  ///< sides by n.x - d
  Integer d;
};

struct Node {
  HalfAngle from, to;
  Faces ball, socket;
};

using Halves = std::array<Faces, 2>;

/// The faces with a corner on the first and on the second side of one of the planes.
Halves halves(const Body& body, const Faces& faces, const std::vector<Plane>& planes) {
  std::vector<unsigned char> sides(body.corners.size());  // 1 first, 2 second; 0 is not known yet
  Halves parts;
  for (const Face& f : faces) {
    for (const Index v : f)
      for (std::size_t i = 0; i < planes.size() && (i > 0 || sides[v] == 0); ++i) {
        const int side = cmp(dot(planes[i].n, body.rest[v]), planes[i].d);
        sides[v] |= side < 0 ? 1 : side > 0 ? 2 : 3;
      }
    for (std::size_t k = 0; k < 2; ++k)
      if (((sides[f[0]] | sides[f[1]] | sides[f[2]]) >> k & 1) != 0) parts[k].push_back(f);
  }
  return parts;
}

/// The faces that may reach the inside of a sphere, r2 >= |unit x|^2, and those that reach its outside.
Halves shells(const Body& body, const Faces& faces, const Integer& unit, const Integer& r2) {
  Halves parts;
  const auto square = [&](const Vec& x) { return Integer(unit * unit * dot(x, x)); };
  for (const Face& f : faces) {
    const Vec &a = body.rest[f[0]], &b = body.rest[f[1]], &c = body.rest[f[2]];
    const auto [least, most] = std::minmax({square(a), square(b), square(c)});
    if (least <= r2 || 3 * (least - r2) <= std::max({square(b - a), square(c - b), square(a - c)}))
      parts[0].push_back(f);
    if (most >= r2) parts[1].push_back(f);
  }
  return parts;
}

// ---- the certificate ----

class Certificate {
 public:
  Certificate(std::istream& in, Body& ball, Body& socket) : in_(in), ball_(ball), socket_(socket) {}

  /// What it proves.
  std::string check() try {
    const Words kind = next("impinge", 3), files = next("files", 2);
    const bool clear = kind[3] == "clear";
    require(kind[1] == "certificate" && kind[2] == "2" && (clear || kind[3] == "contact"),
            "another kind or version");
    require(integer(files[1]) == ball_.files.size() && integer(files[2]) == socket_.files.size(),
            "not so many files");
    const Words centre = next("centre", 3), shift = next("shift", 3);
    const Words outer = next("outer", 4), axis = next("axis", 3), inner = next("inner", 4);
    const auto whole = [](const Words& w, std::size_t k) {
      return Vec{integer(w[k]), integer(w[k + 1]), integer(w[k + 2])};
    };
    outer_ = {integer(outer[1]), whole(outer, 2)}, inner_ = {integer(inner[1]), whole(inner, 2)},
    axis_ = whole(axis, 1);
    require(norm(outer_) > 0 && norm(inner_) > 0 && dot(axis_, axis_) == 1,
            "a quaternion is 0, or the axis not of length 1");
    last_ = half_angle(next("last", 2));
    unit_ = integer(next("unit", 1)[1]);
    require(unit_ > 0, "the unit is not above 0");
    place(centre, shift);
    const File& first = socket_.files[0];
    const int inside = first.closed ? parity(socket_, first, {0, 0, 0}) : -1;
    require(inside != 0, "the centre is on the socket");
    if (clear) check_tree();
    if (!clear) check_contact(inside > 0);
    require(!clear || !one_inside(ball_, ball_.pieces, socket_, inside > 0), "a piece of the ball is inside");
    require(!clear || !one_inside(socket_, socket_.pieces, ball_, false), "a piece of the socket is inside");
    next("end", 0);
    require(in_.peek() == std::istream::traits_type::eof(), "goes on after its end");
    std::ostringstream told;
    const auto tell = [&](const char* what, const Words& words) {
      told << what << words[1] << ' ' << words[2] << ' ' << words[3];
    };
    tell((kind[3] + (last_.s == 0 ? " in a pose: centre " : " on a motion: centre ")).c_str(), centre),
        tell(" mm, shift ", shift);
    const Quaternion start = at({1, 0});
    const double length = std::sqrt(norm(start).get_d());
    told.precision(10);
    told << " mm, quaternion " << start.w.get_d() / length;
    for (const Integer& number : start.v) told << ' ' << number.get_d() / length;
    if (last_.s != 0)
      told << ", then " << 360 / std::numbers::pi * std::atan2(last_.s.get_d(), last_.c.get_d())
           << " degrees about";
    for (const Integer& number : turned(outer_, axis_))
      if (last_.s != 0) told << ' ' << number.get_d() / norm(outer_).get_d();
    return told.str() + ", in the frame of the mesh files";
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("line " + std::to_string(line_) + ": " + error.what());
  }

 private:
  Words next() {
    std::string line, joined;
    require(bool(std::getline(in_, line)), "ends early");
    ++line_;
    Words words = words_of(line);
    for (const auto& word : words) joined += (joined.empty() ? "" : " ") + word;
    require(!words.empty() && joined == line, "not words with a blank between");
    return words;
  }
  Words next(const std::string& what, std::size_t numbers) {
    Words words = next();
    require(words[0] == what && words.size() == numbers + 1, "not '" + what + "' and what belongs to it");
    return words;
  }
  static HalfAngle half_angle(const Words& words) {
    HalfAngle h{integer(words[1]), integer(words[2])};
    require(h.s > 0 || (h.s == 0 && h.c > 0), "no half angle");
    return h;
  }
  [[nodiscard]] Quaternion at(const HalfAngle& h) const {
    return outer_ * Quaternion{h.c, h.s * axis_} * inner_;
  }

  /// Puts both bodies at rest and where the motion starts.
  void place(const Words& centre, const Words& shift) {
    scale_ = lcm(ball_.scale, socket_.scale);
    const auto fractions = [&](const Words& words) {
      std::array<Fraction, 3> x{decimal(words[1]), decimal(words[2]), decimal(words[3])};
      for (const Fraction& value : x) scale_ = lcm(scale_, value.get_den());
      return x;
    };
    const auto c = fractions(centre), t = fractions(shift);
    const auto scaled = [&](const auto& x) {
      return Vec{Integer(x[0] * scale_), Integer(x[1] * scale_), Integer(x[2] * scale_)};
    };
    const Vec origin = scaled(c);
    shift_ = scaled(t);
    const Quaternion start = at({1, 0}), back = inverse(start);
    const Vec x = turned(back, {1, 0, 0}), y = turned(back, {0, 1, 0}), z = turned(back, {0, 0, 1});  // rows
    for (Body* body : {&ball_, &socket_}) {
      body->rest.clear(), body->moved.clear(), body->rounded.clear();
      for (const Vec& corner : body->corners) {
        const Vec r = Integer(scale_ / body->scale) * corner - origin;
        body->rest.push_back(r);
        body->moved.push_back(norm(start) * (body == &ball_ ? shift_ : r));
        if (body == &ball_) body->moved.back() = body->moved.back() + Vec{dot(x, r), dot(y, r), dot(z, r)};
        const Vec& m = body->moved.back();
        body->rounded.push_back({m[0].get_d(), m[1].get_d(), m[2].get_d()});
      }
    }
  }

  /// The plane n.x = d as the nine points of a face of the ball see it, said of its corners at rest.
  [[nodiscard]] std::vector<Plane> seen_at_rest(const Vec& n, const Integer& d, const Node& node) const {
    const Integer s = sine(node.from, node.to), c = cosine(node.from, node.to);
    require(c > 0, "a plane where the arc is not below 180 degrees");
    const Quaternion from = at(node.from), to = at(node.to);
    const Vec a = turned(inverse(from), n), b = turned(inverse(to), n);
    const Integer left = d - dot(n, shift_), ab = norm(from) * norm(to), oi = norm(outer_) * norm(inner_);
    // The third is that of h + (a + b - 2 h) (1 + s^2 / c^2) / 2, times 2 c^2 ab oi; h goes with the axis,
    // which O and I turn.
    const Vec ends = (c * c + s * s) * oi * (norm(to) * a + norm(from) * b);
    const Vec axis = 2 * s * s * ab * dot(n, turned(outer_, axis_)) * turned(inverse(inner_), axis_);
    return {{a, norm(from) * left}, {b, norm(to) * left}, {ends - axis, 2 * c * c * ab * oi * left}};
  }

  void check_tree() {
    std::vector<Node> open{{{1, 0}, last_, ball_.faces, socket_.faces}};
    std::size_t held = 0;  // faces of what is open
    while (!open.empty()) {
      Node first = std::move(open.back());
      open.pop_back();
      held -= std::min(held, first.ball.size() + first.socket.size());
      const Words words = next();
      if (words == Words{"-"}) {
        require(first.ball.empty() || first.socket.empty(), "faces of both bodies are left");
        continue;
      }
      Node second = first;
      Halves ball{first.ball, first.ball}, socket{first.socket, first.socket};
      if (words[0] == "plane" && words.size() == 5) {
        const Vec n{unit_ * integer(words[1]), unit_ * integer(words[2]), unit_ * integer(words[3])};
        const Integer d = scale_ * integer(words[4]);
        ball = halves(ball_, first.ball, seen_at_rest(n, d, first)),
        socket = halves(socket_, first.socket, {{n, d}});
      } else if (words[0] == "sphere" && words.size() == 2) {
        const Integer r = scale_ * integer(words[1]);
        require(r > 0 && shift_ == Vec{0, 0, 0}, "a sphere without radius, or of a shifted ball");
        ball = shells(ball_, first.ball, unit_, r * r), socket = shells(socket_, first.socket, unit_, r * r);
      } else {
        require(words[0] == "turn" && words.size() == 3, "no cut");
        first.to = second.from = half_angle(words);
        require(sine(first.from, first.to) >= 0 && sine(second.from, second.to) >= 0,
                "a turn beyond the arc");
      }
      first.ball = std::move(ball[0]), second.ball = std::move(ball[1]);
      first.socket = std::move(socket[0]), second.socket = std::move(socket[1]);
      held += first.ball.size() + first.socket.size() + second.ball.size() + second.socket.size();
      require(held < 100'000'000, "more faces at once than memory may hold");
      open.push_back(std::move(second));
      open.push_back(std::move(first));
    }
  }

  void check_contact(bool bone_outside) {
    require(last_.s == 0, "contact of a motion");
    const Words words = next();
    if (words == Words{"inside"}) {
      const auto any = [&](std::ptrdiff_t a, std::ptrdiff_t b) {
        return one_inside(ball_, a, socket_, bone_outside) || one_inside(socket_, b, ball_, false);
      };
      require(any(ball_.pieces, socket_.pieces) || any(std::ssize(ball_.used), std::ssize(socket_.used)),
              "no corner is inside");
      return;
    }
    require(words[0] == "cross" && words.size() == 3, "neither 'cross' nor 'inside'");
    const auto face = [](const Body& body, Integer left) {
      for (const Face& f : body.faces)
        if (!two_equal(f) && left-- == 0) return f;
      throw std::runtime_error("no such face");
    };
    const Face a = face(ball_, integer(words[1])), b = face(socket_, integer(words[2]));
    require(edge_meets(ball_, a, socket_, b) || edge_meets(socket_, b, ball_, a), "these faces do not cross");
  }

  std::istream& in_;
  Body &ball_, &socket_;
  Quaternion outer_, inner_;
  Vec axis_, shift_;
  HalfAngle last_;
  Integer unit_, scale_;
  int line_ = 0;
};

int run(const Words& words) {
  std::array<Words, 3> names;  // certificates, files of the ball, of the socket
  std::size_t into = 0;
  for (const auto& word : words) {
    if (!word.starts_with("--"))
      names[into].push_back(word);
    else
      into = word == "--ball-part"     ? 1
             : word == "--socket-part" ? 2
                                       : throw std::invalid_argument(word + ": no option");
  }
  if (names[0].size() < 3)
    throw std::invalid_argument(
        "check_certificate FILE... BALL SOCKET [--ball-part FILE...] [--socket-part FILE...]");
  for (const std::size_t body : {2U, 1U}) {
    names[body].insert(names[body].begin(), names[0].back());
    names[0].pop_back();
  }
  Body ball = read_body(names[1]), socket = read_body(names[2]);
  std::string meshes;
  for (std::size_t k = 1; k < 3; ++k)
    for (std::size_t i = 0; i < names[k].size(); ++i)
      meshes += (k == 1 ? "; ball " : "; socket ") + names[k][i] +
                ((k == 1 ? ball : socket).files[i].closed ? " (closed)" : " (not closed)");
  int code = 0;
  for (const auto& name : names[0]) try {
      std::ifstream in(name, std::ios::binary);
      if (!in) throw std::invalid_argument(name + " cannot be read");
      std::cout << Certificate(in, ball, socket).check() + meshes + "\n";
    } catch (const std::runtime_error& error) {
      std::cout << "not proven: " << name << ", " << error.what() << "\n";
      code = 1;
    }
  return code;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run({words + 1, words + count});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cout << "not proven: " << error.what() << "\n";
    return 1;
  }
}
