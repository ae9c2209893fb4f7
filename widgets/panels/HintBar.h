// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

namespace handwheel {

// The present effect of a mouse button or key.
struct Hint {
  QString input;        // "Middle drag"
  QString effect;       // "orbit"
  bool enabled = true;  // false: not available in the present state

  bool operator==(const Hint&) const = default;
};

// The bar at the bottom that shows the effect of each input. If not all hints fit, those of unavailable inputs are
// omitted, and the first of the others are shown as far as they fit. The tooltip contains all hints.
class HintBar : public QWidget {
  Q_OBJECT

 public:
  explicit HintBar(QWidget* parent = nullptr);

  void setHints(std::vector<Hint> hints);
  std::vector<Hint> shownHints() const;  // hints that fit into the present width
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  int widthOf(const Hint& hint) const;
  void draw(QPainter& painter, const Hint& hint, int x) const;

  std::vector<Hint> m_hints;
};

}  // namespace handwheel
