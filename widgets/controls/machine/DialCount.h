// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// The position of a slide in turns and divisions of its dial. They are counted from the zero that was set. Plain
// values, any thread; mm. Values that are not finite change nothing.
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

  // Returns the reading in divisions. Within a thousandth of a division of a tenth it is that tenth.
  double divisions() const;
  double turns() const;         // whole turns, rounded down
  double restOfTurn() const;    // divisions, 0 to below perTurn()
  double wheelDegrees() const;  // clockwise rotation of the wheel, 0 to below 360, independent of the zero

  // Returns the value after some tenths of a division. From a position on a tenth it comes to one on a tenth.
  double after(double tenths) const;

 private:
  double m_value = 0.0;
  double m_zero = 0.0;
  int m_perTurn = 100;
  double m_mmPerDivision = 0.05;
};

}  // namespace handwheel
