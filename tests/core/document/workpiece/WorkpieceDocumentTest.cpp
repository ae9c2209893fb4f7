// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceDocument.h"

#include "TestClass.h"
#include "document/workpiece/WorkpieceKind.h"

#include <rapidcheck.h>

#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <limits>
#include <map>

using namespace handwheel;

class WorkpieceDocumentTest : public QObject {
  Q_OBJECT

 private slots:
  void blankIsABarOfFifty();
  void propertiesAreListed();
  void setsProperties();
  void materialsInTheLanguageOfTheWindow();
  void sameValueIsNoStep();
  void stepsOfOnePropertyMerge();
  void refusesValues_data();
  void refusesValues();
  void undoAndRedoAreInverse();
  void trianglesAreSharedUntilTheyChange();
  void snapshotsStay();
};

namespace {

const WorkpieceKind& kind() {
  static const WorkpieceKind kind;
  return kind;
}

std::unique_ptr<Document> blankDocument() {
  return kind().make(DocumentKinds::blank(kind()));
}

const WorkpieceSnapshot& valueOf(const Document& document) {
  return static_cast<const WorkpieceDocument&>(document).workpiece();
}

Property propertyOf(const Document& document, const std::string& id) {
  for (const Property& property : document.properties()) {
    if (property.id == id) return property;
  }
  qFatal("no property %s", id.c_str());
}

struct State {
  StockCylinder stock;
  double chord;
  std::string material;
  bool operator==(const State&) const = default;
};

State stateOf(const Document& document) {
  const WorkpieceSnapshot& value = valueOf(document);
  return {value.stock, value.chord, value.material};
}

// Any property with a value that it can have, now and then the one that it has.
void changeSomething(Document& document) {
  static const std::vector<std::string> ids = {"diameter", "length", "position", "chord"};
  const DragPhase stroke = *rc::gen::arbitrary<bool>() ? DragPhase::Continues : DragPhase::Ends;
  const auto which = *rc::gen::inRange<std::size_t>(0, ids.size() + 1);
  if (which == ids.size()) {
    const auto name = *rc::gen::elementOf(std::vector<std::string>{"", "C45", "Messing ⌀", "铝", "C45"});
    RC_ASSERT(document.setProperty("material", name, stroke).hasValue());
    return;
  }
  const Property property = propertyOf(document, ids[which]);
  const double share = *rc::gen::inRange(0, 5) / 4.0;
  const double value = property.least + share * (property.largest - property.least);
  RC_ASSERT(document.setProperty(ids[which], value, stroke).hasValue());
}

}  // namespace

void WorkpieceDocumentTest::blankIsABarOfFifty() {
  const auto document = blankDocument();
  QCOMPARE(stateOf(*document), (State{{50, 100, 0}, 0.01, ""}));
  QVERIFY(!document->isModified());
  QVERIFY(!document->file().id.empty());
  QCOMPARE(document->kind().id(), std::string("workpiece"));
}

void WorkpieceDocumentTest::propertiesAreListed() {
  const auto document = blankDocument();
  QCOMPARE(propertyOf(*document, "diameter").prefix, std::string("⌀"));
  QCOMPARE(std::get<double>(propertyOf(*document, "diameter").value), 50.0);
  for (const char* id : {"diameter", "length", "position", "chord"}) {
    QVERIFY(propertyOf(*document, id).quantity == Quantity::Length);
    QVERIFY(propertyOf(*document, id).editable);
    QVERIFY(propertyOf(*document, id).least < propertyOf(*document, id).largest);
  }
  QCOMPARE(std::get<double>(propertyOf(*document, "volume").value), M_PI * 625 * 100);
  QCOMPARE(std::get<double>(propertyOf(*document, "area").value), M_PI * 50 * 100 + 2 * M_PI * 625);
  QVERIFY(!propertyOf(*document, "volume").editable);
  QVERIFY(!propertyOf(*document, "area").editable);
  QVERIFY(propertyOf(*document, "display_unit").editable);  // a property of every document
}

void WorkpieceDocumentTest::setsProperties() {
  const auto document = blankDocument();
  QSignalSpy changed(document.get(), &Document::changed);
  const auto revision = document->revision();
  QVERIFY(document->setProperty("diameter", 20.0));
  QVERIFY(document->setProperty("length", 30.0));
  QVERIFY(document->setProperty("position", -5.0));
  QVERIFY(document->setProperty("chord", 0.5));
  QVERIFY(document->setProperty("material", std::string("16MnCr5")));
  QCOMPARE(stateOf(*document), (State{{20, 30, -5}, 0.5, "16MnCr5"}));
  QCOMPARE(changed.size(), 5);
  QVERIFY(document->revision() > revision);
  QVERIFY(document->isModified());
  QCOMPARE(std::get<double>(propertyOf(*document, "volume").value), M_PI * 100 * 30);
}

// Shown and typed in the language of the window; kept, and so written, in English.
void WorkpieceDocumentTest::materialsInTheLanguageOfTheWindow() {
  struct German : QTranslator {
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* text, const char*, int) const override {
      return QLatin1String(text) == QLatin1String("Brass") ? QStringLiteral("Messing") : QString();
    }
  } translator;
  const auto document = blankDocument();
  QVERIFY(document->setProperty("material", std::string("Brass")));
  QCoreApplication::installTranslator(&translator);
  QVERIFY(propertyOf(*document, "material").value == PropertyValue(std::string("Messing")));
  QVERIFY(document->setProperty("material", std::string("Messing")));
  QCOMPARE(document->history()->count(), 1);
  QVERIFY(document->setProperty("material", std::string("own alloy")));
  QVERIFY(propertyOf(*document, "material").value == PropertyValue(std::string("own alloy")));
  QVERIFY(document->setProperty("material", std::string("Messing")));
  QCoreApplication::removeTranslator(&translator);
  QCOMPARE(valueOf(*document).material, std::string("Brass"));
}

void WorkpieceDocumentTest::sameValueIsNoStep() {
  const auto document = blankDocument();
  QVERIFY(document->setProperty("diameter", 50.0));
  QVERIFY(document->setProperty("material", std::string()));
  QCOMPARE(document->history()->count(), 0);
}

void WorkpieceDocumentTest::stepsOfOnePropertyMerge() {
  const auto document = blankDocument();
  for (double d : {60.0, 70.0}) QVERIFY(document->setProperty("diameter", d, DragPhase::Continues));
  QVERIFY(document->setProperty("diameter", 80.0, DragPhase::Ends));
  QCOMPARE(document->history()->count(), 1);
  QVERIFY(document->setProperty("diameter", 90.0));  // another stroke
  QCOMPARE(document->history()->count(), 2);
  QVERIFY(document->setProperty("length", 10.0, DragPhase::Continues));
  QVERIFY(document->setProperty("position", 10.0, DragPhase::Ends));  // the same one, but another property
  QCOMPARE(document->history()->count(), 4);
  document->history()->setIndex(1);
  QCOMPARE(stateOf(*document).stock, (StockCylinder{80, 100, 0}));
  document->history()->undo();
  QCOMPARE(stateOf(*document).stock, (StockCylinder{50, 100, 0}));
  document->history()->redo();
  QCOMPARE(stateOf(*document).stock, (StockCylinder{80, 100, 0}));
}

void WorkpieceDocumentTest::refusesValues_data() {
  QTest::addColumn<QString>("id");
  QTest::addColumn<double>("value");
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const char* id : {"diameter", "length", "chord"}) {
    for (double bad : {0.0, -1.0, 1e300, nan, inf, -inf}) QTest::addRow("%s %g", id, bad) << id << bad;
  }
  for (double bad : {1e8, -1e8, nan, inf}) QTest::addRow("position %g", bad) << "position" << bad;
}

void WorkpieceDocumentTest::refusesValues() {
  QFETCH(QString, id);
  QFETCH(double, value);
  const auto document = blankDocument();
  const Status status = document->setProperty(id.toStdString(), value);
  QVERIFY(!status);
  QCOMPARE(status.error().code, ErrorCode::ValueOutOfRange);
  QCOMPARE(status.error().arguments.size(), std::size_t{4});
  QCOMPARE(document->history()->count(), 0);

  for (const PropertyValue& other : {PropertyValue(true), PropertyValue(std::string("50"))}) {
    const Status wrong = document->setProperty(id.toStdString(), other);
    QVERIFY(!wrong);
    QCOMPARE(wrong.error().code, ErrorCode::ElementMalformed);
  }
  QVERIFY(!document->setProperty("material", 5.0));
  QVERIFY(!document->setProperty("material", std::string("\xff\xfe")));
  QVERIFY(!document->setProperty("material", std::string(1001, 'x')));
  QVERIFY(!document->setProperty("volume", 5.0));
  QVERIFY(!document->setProperty("colour", 5.0));
}

void WorkpieceDocumentTest::undoAndRedoAreInverse() {
  QVERIFY(rc::check("on any sequence of edits", [] {
    const auto document = blankDocument();
    QUndoStack& history = *document->history();
    std::map<int, State> states;  // by index of the history
    const auto remember = [&] { states[history.index()] = stateOf(*document); };
    remember();
    const int edits = *rc::gen::inRange(1, 12);
    for (int i = 0; i < edits; ++i) {
      for (int back = *rc::gen::inRange(0, 3); back > 0 && history.canUndo(); --back) history.undo();
      RC_ASSERT(stateOf(*document) == states[history.index()]);
      changeSomething(*document);
      remember();
    }
    for (int round = 0; round < 2; ++round) {
      for (; history.canUndo(); history.undo()) RC_ASSERT(stateOf(*document) == states[history.index()]);
      RC_ASSERT(stateOf(*document) == (State{{50, 100, 0}, 0.01, ""}));
      for (; history.canRedo(); history.redo()) RC_ASSERT(stateOf(*document) == states[history.index()]);
      RC_ASSERT(stateOf(*document) == states[history.index()]);
    }
  }));
}

void WorkpieceDocumentTest::trianglesAreSharedUntilTheyChange() {
  const auto document = blankDocument();
  const auto soup = [&] { return kind().display(*document->snapshot()).parts.at(0).soup; };
  const auto first = soup();
  QCOMPARE(soup(), first);
  QVERIFY(document->setProperty("position", 40.0));
  QVERIFY(document->setProperty("material", std::string("brass")));
  QCOMPARE(soup(), first);
  QCOMPARE(kind().display(*document->snapshot()).parts[0].pose.translation(), Vec3(0, 0, 40));
  QVERIFY(document->setProperty("length", 40.0));
  QVERIFY(soup() != first);
  QVERIFY((kind().display(*document->snapshot()).bounds().max() - Vec3(25, 25, 80)).norm() < 0.02);
}

void WorkpieceDocumentTest::snapshotsStay() {
  const auto document = blankDocument();
  const SnapshotPointer before = document->snapshot();
  QVERIFY(document->setProperty("diameter", 3.0));
  QCOMPARE(static_cast<const WorkpieceSnapshot&>(*before).stock.diameter, 50.0);
}

HANDWHEEL_TEST(WorkpieceDocumentTest)
#include "WorkpieceDocumentTest.moc"
