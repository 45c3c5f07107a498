#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/floor/criteria.hpp"

namespace surefoot::floor {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Wanted& wanted) {
  switch (wanted.kind) {
    case Wanted::Kind::kLess:
      return "less";
    case Wanted::Kind::kNear:
      return fmt::format("{:g} +- {:g}", wanted.value, wanted.tolerance);
    case Wanted::Kind::kAtMost:
      return fmt::format("at most {:g}", wanted.value);
    case Wanted::Kind::kBelow:
      return fmt::format("-{:g} %", wanted.value);
  }
  return {};
}

std::string text_of(const Figure& figure) { return figure.samples == 0 ? "-" : fmt::format("{:.2f}", figure.mean); }

std::string change_of(const CriterionRow& row) {
  const std::optional<double> percent = row.change_percent();
  return percent ? fmt::format("{:+.0f} %", *percent) : "-";
}

std::string less_of(const CriterionRow& row) {
  return row.wanted.kind == Wanted::Kind::kNear ? "-" : fmt::format("{}, {} of {}", row.less, row.more, row.compared);
}

std::string falls_of(const CriterionRow& row) {
  return fmt::format("{}, {} of {}", row.falls_off, row.falls_on, row.walks);
}

Json json_of(const Figure& figure) {
  return {{"samples", figure.samples}, {"mean", figure.samples == 0 ? Json() : Json(figure.mean)}};
}

std::string csv_of(const Figure& figure) {
  return figure.samples == 0 ? "0," : fmt::format("{},{:.6g}", figure.samples, figure.mean);
}

}  // namespace

std::string criteria_text(const Criteria& criteria) {
  std::string text = fmt::format(
      "KHR-2: each controller of Kim, Park, Oh 2007 on against off, in what it regulates, beside none or the extended "
      "set.\nMeans over landings, steps or walks (samples off, on), of the walks in which neither falls; falls: off, "
      "on.\nless: by {:g} % or more, and in so many walks that it is not luck (sign test, 5 %)\n"
      "  {:<21}  {:<8}  {:<36}  {:<34}  {:<5}  {:>7}  {:>7}  {:>7}  {:<12}  {:<13}  {:>11}  {:>10}  falls\n",
      kClear_percent, "controller", "beside", "experiment", "quantity", "unit", "off", "on", "change", "wanted",
      "verdict", "less, more", "samples");
  for (const CriterionRow& row : criteria.rows) {
    text += fmt::format(
        "  {:<21}  {:<8}  {:<36}  {:<34}  {:<5}  {:>7}  {:>7}  {:>7}  {:<12}  {:<13}  {:>11}  {:>10}  {}\n",
        stabilizer::name(row.controller), row.set == "off" ? "none" : row.set, row.floor, row.what, row.unit,
        text_of(row.off), text_of(row.on), change_of(row), text_of(row.wanted), name(row.verdict()), less_of(row),
        fmt::format("{}, {}", row.off.samples, row.on.samples), falls_of(row));
  }
  return text;
}

std::string criteria_csv(const Criteria& criteria) {
  std::string text =
      "controller,beside,experiment,quantity,unit,samples_off,off,samples_on,on,change_percent,wanted,verdict,less,"
      "more,compared,walks,falls_off,falls_on\n";
  for (const CriterionRow& row : criteria.rows) {
    text += fmt::format("{},{},\"{}\",\"{}\",{},{},{},{},{},{},{},{},{},{},{},{}\n", stabilizer::name(row.controller),
                        row.set, row.floor, row.what, row.unit, csv_of(row.off), csv_of(row.on),
                        row.change_percent() ? fmt::format("{:.4g}", *row.change_percent()) : "", text_of(row.wanted),
                        name(row.verdict()), row.less, row.more, row.compared, row.walks, row.falls_off, row.falls_on);
  }
  return text;
}

std::string to_json(const Criteria& criteria) {
  Json rows = Json::array();
  for (const CriterionRow& row : criteria.rows) {
    rows.push_back({{"controller", stabilizer::name(row.controller)},
                    {"beside", row.set},
                    {"experiment", row.floor},
                    {"quantity", row.what},
                    {"unit", row.unit},
                    {"off", json_of(row.off)},
                    {"on", json_of(row.on)},
                    {"change_percent", row.change_percent() ? Json(*row.change_percent()) : Json()},
                    {"wanted", text_of(row.wanted)},
                    {"verdict", name(row.verdict())},
                    {"less", row.less},
                    {"more", row.more},
                    {"compared", row.compared},
                    {"walks", row.walks},
                    {"falls_off", row.falls_off},
                    {"falls_on", row.falls_on}});
  }
  return Json{{"missed", criteria.missed()}, {"rows", rows}}.dump(2) + "\n";
}

}  // namespace surefoot::floor
