// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/ToolTableDialog.h"

#include "controls/NumberField.h"
#include "machining/TurningPass.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace handwheel {

namespace {

enum Column { kNumber, kBody, kNose, kOrientation, kOffsetX, kOffsetZ, kUpsideDown, kColumns };
constexpr int kMostNumber = 9999, kMostTools = 99;
constexpr double kMostOffset = 1e4;  // mm

QString titleFor(const LatheTool& tool) {
  return QCoreApplication::translate("LatheTool", titleOf(tool.kind)) + QLatin1Char(' ') +
         QString::fromStdString(tool.designation);
}

// Returns the heading of a radius, even if X of the program is a diameter.
QString offsetX() {
  return ToolTableDialog::tr("Offset X") + QStringLiteral(" R");
}

NumberField* lengthField(double value, double least, double largest, const QString& label) {
  auto* field = new NumberField;
  field->setQuantity(Quantity::Length, LengthUnit::Millimetre);
  field->setRange(least, largest);
  field->setValue(value);
  field->setLabel(label);
  return field;
}

QSpinBox* countBox(int value, int least, int largest, const QString& label) {
  auto* box = new QSpinBox;
  box->setRange(least, largest);
  box->setValue(value);
  box->setAccessibleName(label);
  return box;
}

template <class Widget>
Widget* cell(const QTableWidget& table, int row, int column) {
  return static_cast<Widget*>(table.cellWidget(row, column));
}

}  // namespace

ToolTableDialog::ToolTableDialog(const ProgramTools& tools, LatheTools bodies, LatheTools post, ProgramDialect dialect,
                                 QWidget* parent)
    : QDialog(parent),
      m_bodies(std::move(bodies)),
      m_post(std::move(post)),
      m_dialect(dialect),
      m_table(new QTableWidget(0, kColumns, this)) {
  setObjectName(QStringLiteral("toolTableDialog"));
  setWindowTitle(tr("Tools of the program"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(840, 360);
  auto* column = new QVBoxLayout(this);
  auto* text = new QLabel(
      tr("The tools with the T numbers of the program. With a tool of the lathe, its holder, the tool post and the "
         "slide are checked for collisions, too. Tools that are not listed have the nose radius of the panel."),
      this);
  text->setWordWrap(true);
  column->addWidget(text);
  m_table->setObjectName(QStringLiteral("toolTable"));
  m_table->setAccessibleName(windowTitle());
  m_table->setHorizontalHeaderLabels(
      {tr("T"), tr("Tool"), tr("Nose radius"), tr("Orientation"), offsetX(), tr("Offset Z"), tr("Upside down")});
  m_table->horizontalHeader()->setSectionResizeMode(kBody, QHeaderView::Stretch);
  m_table->verticalHeader()->hide();
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  column->addWidget(m_table, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel | QDialogButtonBox::Ok, this);
  const auto button = [&](const QString& words, const char* name) {
    QPushButton* const made = buttons->addButton(words, QDialogButtonBox::ActionRole);
    made->setObjectName(QString::fromLatin1(name));
    return made;
  };
  connect(button(tr("&Add"), "toolTableAdd"), &QPushButton::clicked, this, [this] {
    ProgramTool tool;
    tool.orientation = outsideOrientation(m_dialect);
    addRow(freeNumber(), tool);
  });
  connect(button(tr("&Remove"), "toolTableRemove"), &QPushButton::clicked, this,
          [this] { m_table->removeRow(m_table->currentRow() < 0 ? m_table->rowCount() - 1 : m_table->currentRow()); });
  connect(button(tr("From the &lathe"), "toolTablePost"), &QPushButton::clicked, this, &ToolTableDialog::fromLathe);
  buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("toolTableAccept"));
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    emit chosen(this->tools());
    accept();
  });
  for (const auto& [number, tool] : tools) addRow(number, tool);
}

void ToolTableDialog::addRow(int number, const ProgramTool& tool) {
  const int row = m_table->rowCount();
  if (row >= kMostTools) return;
  m_table->insertRow(row);
  m_table->setCellWidget(row, kNumber, countBox(number, 0, kMostNumber, tr("T")));
  auto* bodies = new QComboBox;
  bodies->setObjectName(QStringLiteral("toolTableBody%1").arg(number));
  bodies->addItem(tr("A nose alone"));
  for (const auto& body : m_bodies) {
    bodies->addItem(titleFor(*body));
    if (body == tool.body) bodies->setCurrentIndex(bodies->count() - 1);
  }
  m_table->setCellWidget(row, kBody, bodies);
  m_table->setCellWidget(row, kNose, lengthField(tool.noseRadius, 0.0, TurningPass::kLargestNose, tr("Nose radius")));
  m_table->setCellWidget(row, kOrientation, countBox(tool.orientation, 0, 9, tr("Orientation")));
  m_table->setCellWidget(row, kOffsetX, lengthField(tool.offset.x(), -kMostOffset, kMostOffset, offsetX()));
  m_table->setCellWidget(row, kOffsetZ, lengthField(tool.offset.y(), -kMostOffset, kMostOffset, tr("Offset Z")));
  auto* upsideDown = new QCheckBox;
  upsideDown->setObjectName(QStringLiteral("toolTableUpsideDown%1").arg(number));
  upsideDown->setAccessibleName(tr("Upside down"));
  upsideDown->setToolTip(
      tr("The insert faces the other side than those of the machine do: it cuts with the other of M3 and M4."));
  upsideDown->setChecked(tool.isTurnedOver);
  m_table->setCellWidget(row, kUpsideDown, upsideDown);
  connect(bodies, &QComboBox::activated, this, [this, bodies] {
    for (int i = 0; i < m_table->rowCount(); ++i)
      if (m_table->cellWidget(i, kBody) == bodies) takeBody(i);
  });
}

// Nose and orientation follow the body, until the user changes them.
void ToolTableDialog::takeBody(int row) {
  const int index = cell<QComboBox>(*m_table, row, kBody)->currentIndex();
  if (index <= 0) return;
  const ProgramTool tool = programToolOf(m_bodies[static_cast<std::size_t>(index - 1)], m_dialect);
  cell<NumberField>(*m_table, row, kNose)->setValue(tool.noseRadius);
  cell<QSpinBox>(*m_table, row, kOrientation)->setValue(tool.orientation);
}

void ToolTableDialog::fromLathe() {
  m_table->setRowCount(0);
  int number = 0;
  for (const auto& body : m_post) addRow(++number, programToolOf(body, m_dialect));
}

int ToolTableDialog::freeNumber() const {
  int last = 0;
  for (int i = 0; i < m_table->rowCount(); ++i) last = std::max(last, cell<QSpinBox>(*m_table, i, kNumber)->value());
  return std::min(last + 1, kMostNumber);
}

// If two rows have the same number, the last one counts.
ProgramTools ToolTableDialog::tools() const {
  ProgramTools tools;
  for (int i = 0; i < m_table->rowCount(); ++i) {
    ProgramTool tool;
    tool.noseRadius = cell<NumberField>(*m_table, i, kNose)->value();
    tool.orientation = cell<QSpinBox>(*m_table, i, kOrientation)->value();
    tool.offset = {cell<NumberField>(*m_table, i, kOffsetX)->value(),
                   cell<NumberField>(*m_table, i, kOffsetZ)->value()};
    tool.isTurnedOver = cell<QCheckBox>(*m_table, i, kUpsideDown)->isChecked();
    const int body = cell<QComboBox>(*m_table, i, kBody)->currentIndex();
    if (body > 0) tool.body = m_bodies[static_cast<std::size_t>(body - 1)];
    tools[cell<QSpinBox>(*m_table, i, kNumber)->value()] = tool;
  }
  return tools;
}

}  // namespace handwheel
