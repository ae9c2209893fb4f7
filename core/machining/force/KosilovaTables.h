// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/force/CuttingEdge.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// The law of one component of force, F[N] = 10 C t^x s^y v^n K. t is the depth, s the feed, v the speed, and K the
// product of all corrections. The material factor (strength / reference)^exponent is part of K.
struct KosilovaLaw {
  double c = 0.0, x = 0.0, y = 0.0, n = 0.0;  // c in kgf; c = 0: the table has no such law
  double materialExponent = 0.0;
  bool isVerified = false;  // the constants were compared with the handbook, or with a quotation of it

  bool isGiven() const { return c > 0.0; }
};

// One row of the table of forces: a work material, a tool and an operation.
struct KosilovaRow {
  std::string id, work, operation;
  ToolMaterial tool = ToolMaterial::Carbide;
  std::string source;         // the source of the row, as a sentence
  double reference = 0.0;     // MPa or HB of the work that was measured; 0: no correction
  bool isByHardness = false;  // true: `reference` is a hardness (HB); false: a tensile strength (MPa)
  KosilovaLaw cutting, radial, feed;
};

// A factor as a function of an angle (rad) or a length (mm). It is linear between its entries and constant beyond them.
struct KosilovaCorrection {
  enum class Of { Approach, Rake, Inclination, Nose };
  Of of = Of::Approach;
  std::optional<ToolMaterial> tool;            // none: the factors apply to any tool
  std::vector<double> at;                      // angles or lengths, ascending
  std::array<std::vector<double>, 3> factors;  // factors of the cutting, radial and feed force
  std::vector<double> verifiedAt;              // entries with a verified factor of the cutting force
};

// The factors of an edge on the three components of force. isVerified: the factor of the cutting force rests on
// verified entries only.
struct EdgeFactors {
  double cutting = 1.0, radial = 1.0, feed = 1.0;
  bool isVerified = true;
};

// The tables of Kosilova and Meshcheryakov for turning forces. They are tables 22 and 23 of volume 2 of the handbook.
class KosilovaTables {
 public:
  // Reads tables from JSON. Errors: ElementMalformed.
  static Result<KosilovaTables> fromJson(std::string_view text);
  // Returns the shipped tables. They are read at the first use and shared by all callers.
  static const KosilovaTables& standard();

  const std::vector<KosilovaRow>& rows() const { return m_rows; }
  const KosilovaRow* find(std::string_view id) const;  // null if there is no such row

  // Returns the factors for the values that the edge gives. A value that the edge does not give has
  // the factor 1.
  EdgeFactors factorsOf(const CuttingEdge& edge) const;

 private:
  std::vector<KosilovaRow> m_rows;
  std::vector<KosilovaCorrection> m_corrections;
};

}  // namespace handwheel
