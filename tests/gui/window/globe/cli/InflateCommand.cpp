// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/cli/InflateCommand.h"

#include "base/NumberText.h"
#include "cli/Messages.h"
#include "cli/OperationJson.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "globe/document/GlobeDocument.h"

#include <algorithm>

namespace handwheel::test {

namespace {

const Operation& inflateOperation() {
  static const Operation operation = {
      .id = "inflate",
      .title = "Inflate",
      .meaning = "Make a globe larger, or smaller",
      .operands = "IN",
      .parameters = {
          {.property = {.id = "by", .group = {}, .label = "Factor", .value = 2.0, .least = 0.1, .largest = 10.0},
           .meaning = "Factor of the radius",
           .word = "N"},
          {.property = {.id = "at-most",
                        .group = {},
                        .label = "Largest radius",
                        .value = 0.0,
                        .quantity = Quantity::Length,
                        .least = 1.0,
                        .largest = 1000.0},
           .meaning = "No larger than this radius",
           .word = "MM",
           .hasDefault = false},
      }};
  return operation;
}

CommandSpec inflateSpec() {
  CommandSpec spec = {inflateOperation().id, "IN", "Makes a globe larger, or smaller.", {}};
  spec.options = optionsOf(inflateOperation());
  spec.options.push_back({"output", 'o', "OUT", "The result"});
  spec.options.push_back({"json", 0, "", "Print the figures as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return spec;
}

int runInflate(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(inflateOperation());
  if (const std::string problem = readOptions(arguments, values); !problem.empty())
    return failUsage(problem, "inflate");
  const Result<OpenedFile> opened = kinds.open(arguments.operands[0], {});
  if (!opened) return fail(opened.error());
  if (opened->kind->id() != "globe") return refuse(arguments.operands[0] + " is no globe.");
  const double radius =
      std::min(values.number("by") * radiusOf(*opened->content), values.given("at-most").value_or(1000.0));
  const auto written =
      saveDocument(*opened->kind, opened->file,
                   GlobeSnapshot(withGlobe(bodiesOf(*opened->content), surfaceOf(*opened->content).withRadius(radius))),
                   arguments.valueOf("output"));
  if (!written) return fail(written.error());
  if (!arguments.has("json")) return print("Radius: " + shortestText(radius) + " mm\n");
  return print(textOf({{"options", toJson(values)}, {"radius_mm", radius}}));
}

}  // namespace

Command inflateCommand() {
  return {inflateSpec(), runInflate};
}

}  // namespace handwheel::test
