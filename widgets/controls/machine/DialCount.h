// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// The position of a slide in turns and divisions of its dial. They are counted from the zero that was set. Lengths are
// in mm, and values that are not finite change nothing. Different objects may be used on different threads.
class DialCount {
 public:
  static constexpr int kMostDivisions = 1000;

  void setValue(double mm);
  void setZero(double mm);
  void setDivisions(int perTurn, double mmPerDivision);

  double value() const { return m_value; }
  double zero() const { return m_zero; }
  double reading() const { return m_value - m_zero; }  // mm
  int perTurn() const { return m_perTurn; }
  double mmPerDivision() const { return m_mmPerDivision; }

  // Returns the reading in divisions. If it differs from a multiple of 0.1 by at most 0.001, it is rounded to this
  // multiple.
  double divisions() const;
  double turns() const;         // whole turns, rounded down
  double restOfTurn() const;    // divisions, 0 to below perTurn()
  double wheelDegrees() const;  // clockwise rotation of the wheel, 0 to below 360, independent of the zero

  // Returns the value after turning by some tenths of a division. If the present position is on a tenth, the result is
  // exactly on a tenth, too.
  double after(double tenths) const;

 private:
  double m_value = 0.0;
  double m_zero = 0.0;
  int m_perTurn = 100;
  double m_mmPerDivision = 0.05;
};

}  // namespace handwheel
