// The options of the three commands on cards: see options.cpp.
#include <fmt/format.h>

#include "options.hpp"
#include "percal/card/solver.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

void add_card_write(CLI::App& card_command, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = card_command.add_subcommand("write", "write the card of a result");
  command
      ->add_option("result", card.result,
                   "result.json of identify, calibrate or fit, or its folder; or of card read --json")
      ->required();
  auto targets = solver_words();
  auto* solver = command->add_option("--solver", card.solver, listed(targets) + ", or csv for a table")->required();
  targets.push_back("csv");
  solver->check(CLI::IsMember(targets));
  command->add_option("--units", card.units, "unit system of the card: si, mm-t-s-MPa, mm-ms-kg-GPa, um-us-ng-MPa");
  command->add_option("--file", card.file, "file to write (default: standard output)");
  command->add_option("--card,--name", card.name, "which of several cards; the name of a single one");
  command->add_option("--density", card.density, "density, such as \"1010 kg/m3\"; a fit does not know it");
  auto* ratio = command->add_option("--bulk-to-shear", card.bulk_to_shear, "K/mu; a fit does not know it");
  command->add_option("--nu", card.nu, "Poisson's ratio instead")->excludes(ratio);
  command->add_option("--mode", card.mode, "with csv: uniaxial (default), equibiaxial, planar or shear");
  command->add_option("--range", card.range, "with csv: stretches LOW:HIGH (default: 0.5:2)");
  command->add_option("--points", card.points, "with csv: rows (default: 31)");
  auto* deck = command->add_option("--deck", card.deck, "the card in a single-element test ready to run: uniaxial")
                   ->check(CLI::IsMember({"uniaxial"}));
  command->add_option("--stretch", card.stretch, "with --deck: stretch at the end (default: 2)")->needs(deck);
  command->add_option("--increments", card.increments, "with --deck: equal steps to it (default: 20)")->needs(deck);
  auto* size = command->add_option("--element-size", card.element_size,
                                   "the erosion strain for elements of your own mesh, such as \"0.1 mm\", by runs of a "
                                   "shot of the result");
  command->add_option("--shot", card.shot, "with --element-size: which of the result's scenes (default: the first)")
      ->needs(size);
  command->add_option("--store", common.store, "with --element-size: store of finished runs")->needs(size);
  command
      ->add_option("--threads", common.threads, "with --element-size: runs side by side (default: one for each core)")
      ->needs(size);
  command->add_flag("--force", card.force, "write the card of data that contradict each other, with a warning in it");
  command->add_flag("--check", common.check, "read and convert, write nothing");
  command->add_flag("--quiet", common.quiet, "print nothing but errors");
  command->footer(
      "Examples: percal card write skin.out/result.json --solver lsdyna --units mm-ms-kg-GPa\n"
      "          percal card write gel.out/result.json --solver febio --density \"1010 kg/m3\" --nu 0.495\n"
      "          percal card write skin.out/result.json --solver calculix --units mm-t-s-MPa --deck uniaxial "
      "--file skin.inp\n"
      "          percal card write skin.out/result.json --solver lsdyna --element-size \"0.2 um\"");
  commands.push_back({command, [&] { return run_card_write(card, common); }, true});
}

void add_card_source(CLI::App& command, CardArguments& card) {
  command.add_option("card", card.card, "a card of one of the programs, or a result of percal")->required();
  command.add_option("--solver", card.solver, "the program (default: found by its keywords)")
      ->check(CLI::IsMember(solver_words()));
  command.add_option("--units", card.units, "units of its numbers (default: as the comment of a percal card says)");
  command.add_option("--name", card.name, "which of several materials");
}

void add_card_read(CLI::App& card_command, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = card_command.add_subcommand("read", "the material that a card means, in percal's convention");
  add_card_source(*command, card);
  command->add_flag("--json", common.json, "print the card object, which card write takes");
  command->footer("Example: percal card read skin.k");
  commands.push_back({command, [&] { return run_card_read(card, common); }});
}

void add_card_check(CLI::App& card_command, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = card_command.add_subcommand("check", "the stress-stretch curve that a card means");
  add_card_source(*command, card);
  command->add_option("--mode", card.mode, "uniaxial (default), equibiaxial, planar or shear");
  command->add_option("--stretch", card.range, "stretches LOW:HIGH (default: 0.5:2; in shear 0:1)");
  command->add_option("--points", card.points, "points of the curve (default: 31)");
  command->add_option("--csv", card.csv, "write the curve to this file, for percal fit and for tables");
  command->add_flag("--json", common.json, "print the card object and the curve");
  command->footer("Example: percal card check skin.k --mode equibiaxial --stretch 0.8:1.5");
  commands.push_back({command, [&] { return run_card_check(card, common); }});
}

}  // namespace

void add_card(CLI::App& app, CardArguments& card, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand("card", "material cards for finite-element programs");
  command->require_subcommand(1);
  add_card_write(*command, card, common, commands);
  add_card_read(*command, card, common, commands);
  add_card_check(*command, card, common, commands);
}

}  // namespace percal::tools
