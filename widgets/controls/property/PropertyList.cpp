// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/property/PropertyList.h"

#include "controls/FoldButton.h"
#include "controls/property/PropertyRow.h"

#include <QCoreApplication>
#include <QLabel>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {
constexpr int kUsualWidth = 256;
constexpr int kRemarkLines = 3;    // lines reserved below a form
constexpr int kRemarkMargin = 4;   // pixels around the remarks
constexpr int kRemarkIndent = 12;  // pixels, the same as for the fields
}  // namespace

PropertyList::PropertyList(QWidget* parent)
    : QScrollArea(parent), m_page(new QWidget(this)), m_column(new QVBoxLayout(m_page)), m_empty(new QLabel(m_page)) {
  setObjectName(QStringLiteral("propertyList"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);  // its fields have it
  m_empty->setProperty("muted", true);
  m_empty->setWordWrap(true);
  m_column->setContentsMargins(12, 8, 12, 12);
  m_column->setSpacing(8);
  m_column->addWidget(m_empty);
  m_column->addStretch();
  setWidget(m_page);
}

void PropertyList::setProperties(const std::vector<Property>& properties) {
  const bool same = fit(properties);
  m_properties = properties;
  if (!same) return rebuild();
  for (std::size_t i = 0; i < m_rows.size(); ++i) m_rows[i]->showProperty(m_properties[i], m_unit);
  foldRows();
  showRemarks();
}

void PropertyList::setFolding(const std::map<std::string, bool>& open) {
  for (const auto& [group, isOpen] : open) {
    const auto before = m_openAtFirst.find(group);
    if (before == m_openAtFirst.end() || before->second != isOpen) m_isOpen[group] = isOpen;
  }
  const bool isSame = m_openAtFirst == open;
  m_openAtFirst = open;
  if (!isSame) rebuild();
}

void PropertyList::foldRows() {
  if (m_openAtFirst.empty()) return;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const std::string& group = m_properties[i].group;
    if (m_openAtFirst.contains(group)) m_rows[i]->setVisible(m_isOpen[group]);
  }
  updateGeometry();
}

// Returns true if the present rows and headings are right for them.
bool PropertyList::fit(const std::vector<Property>& properties) const {
  if (properties.size() != m_rows.size()) return false;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    if (!m_rows[i]->fits(properties[i]) || properties[i].group != m_properties[i].group) return false;
  }
  return true;
}

// Keeps the rows that still fit, at any position.
void PropertyList::rebuild() {
  const int scrolled = verticalScrollBar()->value();
  std::vector<PropertyRow*> old = std::exchange(m_rows, {});
  for (QWidget* heading : std::exchange(m_headings, {})) {  // one may be the sender
    heading->hide();
    heading->deleteLater();
  }
  while (m_column->count() > 0) delete m_column->takeAt(0);  // the items; the widgets stay
  m_column->addWidget(m_empty);
  m_empty->setVisible(m_properties.empty());
  const std::string* group = nullptr;
  for (const Property& property : m_properties) {
    if (!group || *group != property.group) addHeading(property);
    group = &property.group;
    const auto kept = std::find_if(old.begin(), old.end(), [&](const PropertyRow* row) { return row->fits(property); });
    PropertyRow* row = kept == old.end() ? addRow(property) : *kept;
    if (kept != old.end()) {
      old.erase(kept);
      row->showProperty(property, m_unit);
    }
    m_rows.push_back(row);
    m_column->addWidget(row);
  }
  m_column->addStretch();
  for (PropertyRow* row : old) {  // one of them may be the sender of the present signal
    row->hide();
    row->deleteLater();
  }
  foldRows();
  showRemarks();
  chainTab();
  updateGeometry();
  // The page is short until it is laid out anew, which scrolls it up.
  QTimer::singleShot(0, this, [this, scrolled] { verticalScrollBar()->setValue(scrolled); });
}

// Orders the tab chain down the page, also after rows were moved or added.
void PropertyList::chainTab() {
  QWidget* last = nullptr;
  for (const PropertyRow* row : m_rows) {
    for (QWidget* part : row->findChildren<QWidget*>()) {
      if (!(part->focusPolicy() & Qt::TabFocus) || part->window() != window()) continue;
      if (last) setTabOrder(last, part);
      last = part;
    }
  }
}

// A field that is being edited loses the focus with the list, and would report its value to a list that is partly
// destroyed.
PropertyList::~PropertyList() {
  for (PropertyRow* row : m_rows) row->disconnect(this);
}

void PropertyList::setLengthUnit(LengthUnit unit) {
  m_unit = unit;
  for (std::size_t i = 0; i < m_rows.size(); ++i) m_rows[i]->showProperty(m_properties[i], unit);
}

void PropertyList::refuse(const std::string& id, const PropertyValue& entered, const QString& reason) {
  const auto row =
      std::find_if(m_rows.begin(), m_rows.end(), [&](const PropertyRow* each) { return each->id() == id; });
  if (row != m_rows.end()) (*row)->refuse(entered, reason);
}

void PropertyList::setEmptyText(const QString& text) {
  m_empty->setText(text);
}

void PropertyList::reserveRemarkSpace() {
  m_remarks = new QLabel(this);
  m_remarks->setObjectName(QStringLiteral("propertyRemarks"));
  m_remarks->setProperty("bad", true);
  m_remarks->setTextFormat(Qt::PlainText);
  m_remarks->setWordWrap(true);
  m_remarks->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_remarks->setContentsMargins(kRemarkIndent, kRemarkMargin, kRemarkIndent, kRemarkMargin);
  m_remarks->setFixedHeight(kRemarkLines * m_remarks->fontMetrics().lineSpacing() + 2 * kRemarkMargin);
  setViewportMargins(0, 0, 0, m_remarks->height());
}

// Refused values come first, for somebody is typing them. All of it is in the tool tip, should it be long.
void PropertyList::showRemarks() {
  if (!m_remarks) return;
  QStringList refused, others;
  for (const PropertyRow* row : m_rows) {
    const QString remark = row->namedRemark();
    if (!remark.isEmpty()) (row->isRefused() ? refused : others) << remark;
  }
  const QString text = (refused + others).join(QLatin1Char('\n'));
  m_remarks->setText(text);
  m_remarks->setToolTip(text.isEmpty() ? text : QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped()));
}

void PropertyList::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  if (!m_remarks) return;
  const QRect above = viewport()->geometry();  // without the scroll bar
  m_remarks->setGeometry(above.left(), height() - m_remarks->height(), above.width(), m_remarks->height());
}

QSize PropertyList::sizeHint() const {
  return {kUsualWidth, m_page->heightForWidth(kUsualWidth) + (m_remarks ? m_remarks->height() : 0)};
}

PropertyRow* PropertyList::addRow(const Property& property) {
  PropertyRow* row = PropertyRow::make(property, m_unit, m_page);
  connect(row, &PropertyRow::edited, this, [this, id = property.id](const PropertyValue& value, bool stillDragging) {
    emit edited(id, value, stillDragging);
  });
  connect(row, &PropertyRow::typed, this,
          [this, id = property.id](const PropertyValue& value) { emit typed(id, value); });
  if (!m_remarks) return row;
  row->showRemarkOutside();
  connect(row, &PropertyRow::remarkChanged, this, &PropertyList::showRemarks);
  return row;
}

void PropertyList::addHeading(const Property& property) {
  const std::string& group = property.group;
  if (group.empty()) return;
  QWidget* const heading =
      makeHeading(group, property.groupTranslated ? QCoreApplication::translate("Property", group.c_str())
                                                  : QString::fromStdString(group));
  heading->setProperty("strong", true);
  m_headings.push_back(heading);
  m_column->addSpacing(m_rows.empty() ? 0 : 8);
  m_column->addWidget(heading);
}

QWidget* PropertyList::makeHeading(const std::string& group, const QString& text) {
  if (!m_openAtFirst.contains(group)) {
    auto* label = new QLabel(text, m_page);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);  // else a long one widens the page beyond the panel
    return label;
  }
  auto* button = new FoldButton(text, m_isOpen[group], m_page);
  button->setObjectName(QStringLiteral("propertyGroup/") + QString::fromStdString(group));
  connect(button, &FoldButton::toggledOpen, this, [this, group](bool isOpen) {
    m_isOpen[group] = isOpen;
    foldRows();
  });
  return button;
}

}  // namespace handwheel
