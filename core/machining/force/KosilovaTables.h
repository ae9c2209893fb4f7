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

// The law of one component of force, F[N] = 10 C t^x s^y v^n K. The material factor (strength / reference)^exponent is
// part of K.
struct KosilovaLaw {
  double c = 0.0, x = 0.0, y = 0.0, n = 0.0;  // c in kgf; 0: the table has no such law
  double materialExponent = 0.0;
  bool isVerified = false;  // compared with the handbook, or with a quotation of it

  bool isGiven() const { return c > 0.0; }
};

// One row of the table of forces: a work material, a tool and an operation.
struct KosilovaRow {
  std::string id, work, operation;
  ToolMaterial tool = ToolMaterial::Carbide;
  std::string source;         // a sentence
  double reference = 0.0;     // MPa or HB of the work in the measurement; 0: no correction
  bool isByHardness = false;  // HB, else tensile strength
  KosilovaLaw cutting, radial, feed;
};

// A factor as a function of an angle (radian) or a length (mm), linear between its entries and constant beyond.
struct KosilovaCorrection {
  enum class Of { Approach, Rake, Inclination, Nose };
  Of of = Of::Approach;
  std::optional<ToolMaterial> tool;            // none: any
  std::vector<double> at;                      // ascending
  std::array<std::vector<double>, 3> factors;  // cutting, radial, feed
  std::vector<double> verifiedAt;              // entries with a verified factor of the cutting force
};

// The factors of an edge on the three components. isVerified: that on the cutting force rests on verified entries only.
struct EdgeFactors {
  double cutting = 1.0, radial = 1.0, feed = 1.0;
  bool isVerified = true;
};

// The tables of Kosilova and Meshcheryakov for turning forces. Handbook, volume 2, tables 22 and 23.
class KosilovaTables {
 public:
  // Errors: ElementMalformed.
  static Result<KosilovaTables> fromJson(std::string_view text);
  // Returns the shipped tables: shared, read at the first use.
  static const KosilovaTables& standard();

  const std::vector<KosilovaRow>& rows() const { return m_rows; }
  const KosilovaRow* find(std::string_view id) const;  // null when unknown

  // Returns the factors for the values that the edge gives; other values are as in the rows, with factor 1.
  EdgeFactors factorsOf(const CuttingEdge& edge) const;

 private:
  std::vector<KosilovaRow> m_rows;
  std::vector<KosilovaCorrection> m_corrections;
};

}  // namespace handwheel
