#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "checkpoint_options.hpp"
#include "commands.hpp"
#include "launcher.hpp"
#include "usage.hpp"
#include "weavefront/scene/read.hpp"

// The only source that includes CLI11, which takes long to compile.

namespace weavefront::app {
namespace {

/// Runs a subcommand with the options that were parsed.
template <class Options, class Run>
std::shared_ptr<Options> options_of(CLI::App& command, Run action) {
    auto options = std::make_shared<Options>();
    command.callback([options, action] { action(*options); });
    return options;
}

void add_scene(CLI::App& command, std::filesystem::path& scene, std::vector<std::string>& overrides,
               const std::string& description = "Scene file (YAML)") {
    command.add_option("SCENE", scene, description)->required();
    command
        .add_option("--set", overrides,
                    "Override a value of the scene, PATH=VALUE; may be given several times")
        ->allow_extra_args(false);
}

void add_fabric(CLI::App& command, std::string& fabric) {
    command.add_option("--fabric", fabric, "Name of the fabric, where the scene has several");
}

std::string refuse_unless_share(const std::string& text) {
    double share = -1;
    const bool number = CLI::detail::lexical_cast(text, share) && share >= 0 && std::isfinite(share);
    return number ? std::string()
                  : "found '" + text + "', allowed a number of at least 0, such as 0.1 for 10 %";
}

/// Adds an option of the checkpoints. @param read puts a text into the plan and returns what is wrong with it
void add_checkpoint_option(CLI::App& command, const std::string& name,
                           std::string (*read)(const std::string&, CheckpointPlan&), CheckpointPlan& plan,
                           const std::string& description) {
    command.add_option_function<std::string>(
        name,
        [name, read, &plan](const std::string& text) {
            const auto problem = read(text, plan);
            if (!problem.empty()) throw CLI::ValidationError(name, problem);
        },
        description);
}

void add_run(CLI::App& app) {
    auto* command = app.add_subcommand("run", "Compute an impact: mpirun -n N weavefront run SCENE");
    auto options = options_of<RunOptions>(*command, run);
    add_scene(*command, options->scene, options->overrides);
    command->add_option(
        "--output", options->output,
        "Folder for history.csv, results.vtkhdf, summary.json and run.log (default: runs/<scene name>)");
    auto* overwrite =
        command->add_flag("--overwrite", options->overwrite,
                          "Replace an earlier run in the folder, when the new one is certain to start");
    command
        ->add_option("--rebalance", options->rebalance,
                     "Move columns between the ranks whenever the slowest stays above the mean by more than "
                     "this share; 0.1 is 10 %")
        ->check(refuse_unless_share);
    add_checkpoint_option(
        *command, "--checkpoint-every", read_checkpoint_interval, options->checkpoints,
        "Write a checkpoint after so much wall time or so many steps: '10 min', '5000 steps'");
    add_checkpoint_option(*command, "--walltime", read_walltime, options->checkpoints,
                          "Write a checkpoint and leave before this wall time is over; the end of a Slurm "
                          "job is found by itself");
    command
        ->add_option("--restart", options->restart,
                     "Go on from a checkpoint: auto (the newest whole one in the output folder) or a file")
        ->excludes(overwrite);
}

void add_check(CLI::App& app) {
    auto* command = app.add_subcommand("check",
                                       "Validate a scene; print its size, memory, time step, steps, run time "
                                       "and what is left out, and warn");
    auto options = options_of<CheckOptions>(*command, check);
    add_scene(*command, options->scene, options->overrides);
}

void add_cell(CLI::App& app) {
    auto* command = app.add_subcommand("cell", "Take one material point through a prescribed deformation");
    auto options = options_of<CellOptions>(*command, cell);
    add_scene(*command, options->scene, options->overrides, "Scene file (YAML); only its fabrics are read");
    command
        ->add_option("--path", options->path,
                     "CSV with the columns time,F11,F12,F21,F22: deformation gradient in the initial yarn "
                     "axes (1 fill, 2 warp), first row the identity, one material step a row")
        ->required();
    command
        ->add_option("--out", options->out,
                     "CSV to write, SI units, stresses in the bisector frame of the yarns")
        ->required();
    add_fabric(*command, options->fabric);
}

void add_yarn(CLI::App& app) {
    auto* command = app.add_subcommand(
        "yarn", "Stress-strain curves of one yarn at constant strain rates, up to its failure");
    auto options = options_of<YarnOptions>(*command, yarn);
    add_scene(*command, options->scene, options->overrides, "Scene file (YAML); only its fabrics are read");
    command->add_option("--rates", options->rates, "Strain rates in 1/s, separated by commas")->required();
    command
        ->add_option("--out", options->out,
                     "CSV to write: rate,time,strain,stress,failure; failure is 0, 19 or 20, the equation of "
                     "the paper that was met; a fabric without failure is strained to 5 %")
        ->required();
    command->add_option("--yarn", options->yarn,
                        "Which yarn, where fill and warp differ: fill or warp (default: fill)");
    add_fabric(*command, options->fabric);
}

void add_fabrics(CLI::App& app) {
    auto* command =
        app.add_subcommand("fabrics", "List the fabrics of the library: every value with its source");
    auto options = options_of<LibraryOptions>(*command, fabrics);
    command->add_option("NAME", options->name, "One fabric (default: all)");
}

void add_projectiles(CLI::App& app) {
    auto* command =
        app.add_subcommand("projectiles", "List the projectiles of the library: every value with its source");
    auto options = options_of<LibraryOptions>(*command, projectiles);
    command->add_option("NAME", options->name, "One projectile (default: all)");
}

void add_study(CLI::App& app) {
    auto* command = app.add_subcommand(
        "study", "Compute variants of a scene and their errors: mpirun -n N weavefront study STUDY");
    auto options = options_of<StudyOptions>(*command, study);
    command->add_option("STUDY", options->study, "Study file (YAML)")->required();
    command->add_option("--output", options->output,
                        "Folder for study.csv, study.json, study.png and one folder a variant (default: "
                        "runs/<study name>); variants that it holds already are not computed again");
    command->add_option("--check", options->check,
                        "A study.csv of before: status 1 when a quantity is off by more than its tolerance "
                        "in the study file");
    command->add_flag("--no-picture", options->no_picture, "Do not have weavefront-plot draw study.png");
}

void add_limit_options(CLI::App& command, V50Options& options) {
    command.add_option(
        "--from", options.from,
        "Lowest striking velocity, such as '200 m/s' or '650 ft/s' (default: looked for from the "
        "scene's velocity downwards)");
    command.add_option("--to", options.to, "Highest striking velocity (default: looked for upwards)");
    command.add_option("--width", options.width, "Width of the last bracket (default: 5 m/s)");
    command.add_option(
        "--complete", options.complete,
        "Which shots are complete penetrations: 'perforated', all plies (default); 'any-ply', at "
        "least one; 'witness 30 m/s', all plies at a residual velocity of at least 30 m/s");
    command.add_option("--mesh", options.mesh,
                       "Element sizes at the impact, separated by commas: the limit is found for each");
    command.add_option("--stiffness", options.stiffness,
                       "Factors on the contact stiffness, separated by commas: the limit is found for each");
}

void add_scatter_options(CLI::App& command, V50Options& options) {
    command
        .add_option(
            "--scatter", options.scatter,
            "A value of the scene that differs from shot to shot: 'PATH=normal(MEAN, DEVIATION)', "
            "'PATH=uniform(LOW, HIGH)', or 'PATH=seed' for the number of the shot; may be given several "
            "times")
        ->allow_extra_args(false);
    command.add_option("--seed", options.seed, "Of the scatter (default: 1)");
    command.add_option("--count", options.count, "Shots with scatter (default: 20)");
    command.add_option(
        "--sigma", options.sigma,
        "Guess of the standard deviation of V50, with scatter (default: a twentieth of the way "
        "from --from to --to)");
    command.add_option(
        "--shots", options.shots,
        "CSV of a range's own shots, added to the fit: columns speed_m_s or speed_ft_s, or speed "
        "with its unit in each cell, and result: complete or partial");
    command.add_option("--confidence", options.confidence, "Of the intervals (default: 0.95)");
}

void add_v50(CLI::App& app) {
    auto* command = app.add_subcommand(
        "v50",
        "Find the ballistic limit of a scene, or its V50 with scatter: mpirun -n N weavefront v50 SCENE");
    auto options = options_of<V50Options>(*command, v50);
    add_scene(*command, options->scene, options->overrides);
    command->add_option("--output", options->output,
                        "Folder for v50.csv, v50.json, plots and one folder a shot (default: runs/<scene "
                        "name>_v50)");
    auto* overwrite =
        command->add_flag("--overwrite", options->overwrite, "Replace an earlier v50 in the folder");
    command
        ->add_option(
            "--restart", options->restart,
            "auto: finished shots of the folder are read, an interrupted one goes on from its checkpoint")
        ->excludes(overwrite);
    add_limit_options(*command, *options);
    add_scatter_options(*command, *options);
    command->add_option("--ranks-per-shot", options->ranks_per_shot,
                        "Shots run side by side on groups of so many ranks (default: all ranks on one shot)");
    add_checkpoint_option(*command, "--checkpoint-every", read_checkpoint_interval, options->checkpoints,
                          "Of each shot, as of run");
    add_checkpoint_option(*command, "--walltime", read_walltime, options->checkpoints,
                          "Write checkpoints and leave before this wall time is over");
    command->add_flag("--no-picture", options->no_picture, "Do not have weavefront-plot draw pictures");
}

void add_partition(CLI::App& app) {
    auto* command =
        app.add_subcommand("partition", "Quality of decompositions and the time of a step that they lead to");
    auto options = options_of<PartitionOptions>(*command, partition);
    add_scene(*command, options->scene, options->overrides);
    command->add_option("--ranks", options->ranks, "Rank counts, such as 1,64,1024");
    command->add_flag("--weak", options->weak,
                      "Refine the mesh with the square root of the rank count from the first one, where the "
                      "scene is as it stands");
    command->add_option("--machine", options->machine,
                        "Constants of a machine, from --calibrate (default: those of the program's own)");
    command->add_flag("--measure", options->measure,
                      "Compute the scene on up to as many ranks as mpirun gives, beside the model");
    command->add_option("--calibrate", options->calibrate,
                        "Measure this machine on the ranks that mpirun gives and write its constants (JSON)");
    command->add_option("--repetitions", options->repetitions,
                        "Of every measured step, of which the quickest counts (default: 3)");
    command->add_option("--out", options->out, "Write the table as CSV");
}

std::vector<std::string> long_options(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

void refuse_unknown_words(const CLI::App& app, const std::vector<std::string>& arguments) {
    std::vector<std::string> subcommands;
    KnownOptions known{{"", long_options(app)}};
    for (const CLI::App* subcommand : app.get_subcommands({})) {
        subcommands.push_back(subcommand->get_name());
        known[subcommand->get_name()] = long_options(*subcommand);
    }
    refuse_unknown(known, subcommands, arguments);
}

}  // namespace

void execute(const std::vector<std::string>& arguments) {
    CLI::App app("Ballistic impact on woven-fabric armour", "weavefront");
    app.set_version_flag("--version", "weavefront " WEAVEFRONT_VERSION);
    app.footer(
        "Exit status: 0 done, 1 stopped by the physics or numerics guard, 2 bad input or usage, 3 system "
        "error, 4 stopped on request.");
    app.require_subcommand(1);
    for (const auto add : {add_run, add_check, add_cell, add_yarn, add_fabrics, add_projectiles, add_study,
                           add_v50, add_partition})
        add(app);
    refuse_unknown_words(app, arguments);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(),
                                           arguments.rend()));  // the last one first, as CLI11 takes them
    } catch (const CLI::ParseError& error) {
        const bool is_served =
            error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);  // --help, --version
        if (!is_served) throw scene::InputError({std::string(error.what()) + " (see weavefront --help)"});
        if (is_first_process()) app.exit(error);
    }
}

}  // namespace weavefront::app
