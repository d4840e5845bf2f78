"""The subcommands of `python -m grounding`, one module each, imported only when asked for.

A module has `add_arguments(subparsers)`, which adds its parser under the module's name, and `run(args)`, which returns
the exit code. Errors of `GroundingError` and `OSError` are left to `grounding.__main__`.
"""

SUMMARIES = {
    "ground": "words and a world to goals",
    "dialogue": "a conversation: instructions, questions, answers",
    "batch": "ground many instructions from a file",
    "train": "train grammar and weights from a corpus",
    "corpus": "show, check and convert corpora",
    "space": "sizes of the space of symbols",
    "features": "explain and count the features",
    "experiments": "the paper's tables and figures",
}
