"""What every fact of a context and every role of a symbol means: a register of forms.

A new fact or role needs one more line in `FACTS` or `ROLES` below: its form, its meaning and an example. What may stand
in a blank such as <ref> is listed in `grounding.features.blanks`. The first form that fits is taken. A name that no
form fits is shown as unexplained by `python -m grounding features`, and
`tests/grounding/features/test_explained.py` says which these are.
"""

from __future__ import annotations

from grounding.features import blanks
from grounding.features.forms import Blank, Explained, Form, first_of, nested

CONCRETE = ("type", "color", "spatial", "cardinal", "ordinal", "kind", "verb")
BLANKS: dict[str, Blank] = {**blanks.BLANKS}


def _form(template: str, meaning: str, example: str, families: tuple[str, ...] = ()) -> Form:
    return Form(template, meaning, example, families, BLANKS)


SETS = (
    _form("all[<ref>]", "<ref>", "all[mod.in]"),
    _form("only[<ref>]", "the only one of <ref>", "only[all]"),
    _form("count[<ref>|<who>]", "<ref>, which are as many as <who> says", "count[all|own]"),
    _form("nth[<part>.of]", "of what the region of <part> is of, the outermost in its direction", "nth[mod.of]"),
    _form("nth[<ref>|<who>|<rank>]", "of <ref>, the one at <rank> along the direction that <who> says",
          "nth[mod.in|head|first]"),
    _form("flat[<part>.of]", "of what the region of <part> is of, the outermost; top and bottom mean back and front",
          "flat[mod.of]"),
    _form("flat[<ref>|<who>|<rank>]",
          "of <ref>, the one at <rank> along the direction that <who> says; top and bottom mean back and front",
          "flat[all|head|first]"),
    _form("k[<ref>|<who>|<who2>]",
          "of <ref>, as many as <who2> says, the outermost along the direction that <who> says", "k[all|head|head]"),
    _form("middle[<part>.of]", "of what the region of <part> is of, the middle one", "middle[inner.of]"),
    _form("middle[<ref>]", "of <ref>, the middle one by rank along their main axis", "middle[head.in]"),
    _form("central[<ref>]", "of <ref>, the one nearest to the middle of all that lies there", "central[all]"),
    _form("closest[<part>]", "the one nearest to what <part> is grounded to", "closest[mod]"),
    _form("closest[<part>.region]", "of those in the region of <part>, the nearest to its reference",
          "closest[mod.region]"),
)  # fmt: skip
BLANKS["set"] = nested(SETS)

FITS = (
    _form("in[<list>]", "one of <list>", "in[seen]"),
    _form("only[<list>]", "the only one of <list>", "only[evident]"),
    _form("best[<list>]", "the most prominent of <list>", "best[seen]"),
    _form("clear best[<list>]", "by far the most prominent of <list>", "clear best[seen]"),
    _form("largest[<list>]", "of <list>, the one with the most members", "largest[seen]"),
    _form("smallest[<list>]", "of <list>, the one with the fewest members", "smallest[seen]"),
    _form("nth[<list>|<who>|<rank>]", "of <list>, the one at <rank> along the direction that <who> says",
          "nth[evident|mod|first]"),
)  # fmt: skip
BLANKS["fit"] = nested(FITS)

HOWS = (
    _form("container of <part>", "the reference is the container of <part>", "container of inner"),
    _form("containers of <part>", "the reference is all members of the containers of <part>", "containers of inner"),
    _form("object of <part>", "the reference is the one object of <part>", "object of inner"),
    _form("objects of <part>", "the reference is the objects of <part>", "objects of mod"),
    _form("furniture of <part>", "the reference is the furniture of <part>", "furniture of inner"),
    _form("robot of <who>", "the reference is the robot, by <who>", "robot of inner"),
    _form("possible objects of <part>", "the reference is all objects that <part> leaves possible",
          "possible objects of inner"),
    _form("of nothing said", "the reference is nothing that a part is grounded to", "of nothing said"),
)  # fmt: skip
BLANKS["how"] = nested(HOWS)

TARGETS = (
    _form("the object", "acts on the one object of the object phrase", "the object"),
    _form("the objects", "acts on the objects of the object phrase", "the objects"),
    _form("a possible object", "acts on one of the objects that the object phrase leaves possible",
          "a possible object"),
    _form("a possible container", "acts on one of the arrangements that the object phrase leaves possible",
          "a possible container"),
    _form("all that match", "acts on all things that match the object phrase", "all that match"),
    _form("all that match as counted", "acts on all things that match, which are as many as is said",
          "all that match as counted"),
    _form("all that match against the count", "acts on all things that match, which are not as many as is said",
          "all that match against the count"),
    _form("on nothing said", "acts on what no phrase speaks of", "on nothing said"),
)  # fmt: skip
GOALS = (
    _form("to region", "to the region of the destination phrase", "to region"),
    _form("to a possible region", "to the region of one of several objects of the destination phrase",
          "to a possible region"),
    _form("beside itself", "to what lies in the direction said, from where it is", "beside itself"),
    _form("beside itself unsaid", "to what lies in a direction from where it is, and none is said",
          "beside itself unsaid"),
    _form("nowhere", "to no place, and none is said", "nowhere"),
    _form("nowhere though said", "to no place, though one is said", "nowhere though said"),
    _form("to a region unsaid", "to a region that no phrase speaks of", "to a region unsaid"),
)  # fmt: skip
BLANKS["acted"] = Blank(r"[^|]+", nested(TARGETS).say)
BLANKS["goal"] = nested(GOALS)

FACTS: tuple[Form, ...] = (
    _form("bias", "always there", "bias"),
    _form("tag=<tag>", "the phrase is of the category <tag>", "tag=NP"),
    _form("shape=<tag>:<parts>", "the phrase is of the category <tag> and has <parts> as children",
          "shape=NP:head+mod"),
    _form("word=<word>", "the word <word> is among the phrase's own words", "word=middle"),
    _form("pos=<tag>", "an own word has the part of speech <tag>", "pos=JJS"),
    _form("plural", "an own word is a plural noun", "plural"),
    _form("superlative", "an own word is a superlative", "superlative"),
    _form("universal", "an own word means all of a set", "universal"),
    _form("size=<order>", "an own word asks for the <order> arrangement", "size=1"),
    _form("unnamed word", "an own word outside the closed classes", "unnamed word"),
    _form("says <class>", "an own word may name <class>", "says Cardinal"),
    _form("<part>=<tag>", "<part> is of the category <tag>", "head=NP"),
    _form("<part>:indefinite", "<part> begins with an indefinite article", "object:indefinite"),
    _form("<part>:<preposition>", "<part> begins with <preposition>", "mod:in"),
    _form("<part> has <what>", "<part> is grounded to <what>", "mod has containers"),
    _form("<part>.relation=<relation>", "<part> speaks of <relation>", "mod.relation=left"),
    _form("<part>.container=<kind>", "<part> is grounded to a container: <kind>", "mod.container=row"),
    _form("<part>.region=<relation>", "<part> is grounded to a region: <relation>", "mod.region=right"),
    _form("<part>.region of=<target>", "<part> is grounded to a region of: <target>", "mod.region of=row"),
    _form("composed <composition>", "<composition>", "composed head(A)+mod(C)"),
    _form("composed <composition> by <preposition>", "<composition>; joined by <preposition>",
          "composed head(A)+mod(C) by in"),
    _form("two relations:<relation>:<preposition>",
          "head and modifier both speak of a direction; the head's is <relation>, joined by <preposition>",
          "two relations:left:of"),
    _form("own <what>", "the phrase itself is settled to mean <what>", "own relations"),
    _form("own.relation=<relation>", "the phrase itself is settled to mean <relation>", "own.relation=near"),
    _form("own.kind=<kind>", "the phrase itself is settled to mean the kind <kind>", "own.kind=row"),
    _form("own.container=<kind>", "the phrase itself is settled to mean a container: <kind>", "own.container=row"),
    _form("base <every><article><amount> <told>", "its own words speak of <told>; <amount><article><every>",
          "base the several n"),
    _form("nothing matches", "nothing has the type and colour that are said", "nothing matches"),
    _form("one matches", "one thing has the type and colour that are said", "one matches"),
    _form("many match", "several things have the type and colour that are said", "many match"),
    _form("stacked", "those that match lie at several heights", "stacked"),
    _form("level", "those that match lie at one height", "level"),
    _form("rank=<word>", "an own word is the ordinal <word>", "rank=third"),
    _form("own.index=<ordered>", "the phrase itself is settled to mean <ordered>", "own.index=later"),
    _form("<part> ranks <ordered>|<direction>", "<part> is grounded to an attribute: <ordered>, <direction>",
          "head ranks first|along"),
    _form("own ranks <ordered>|<direction>", "the phrase itself has an attribute: <ordered>, <direction>",
          "own ranks first|side"),
    _form("have <set>", "there is such a set: <set>", "have only[all]"),
    _form("empty <ref>", "there is nothing among <ref>", "empty mod.region"),
    _form("<few> <list>", "there is or are <few> of <list>", "1 evident"),
)  # fmt: skip

ROLES: tuple[Form, ...] = (
    # symbols that words express
    _form("named", "an own word may name it", "named", CONCRETE),
    _form("named by head", "the head word may name it", "named by head", CONCRETE),
    _form("named by its own name", "a word is its very name", "named by its own name", ("type",)),
    _form("named by <tag>", "a word with the part of speech <tag> may name it", "named by JJ", CONCRETE),
    _form("is a side", "it is left or right", "is a side", ("spatial",)),
    _form("<relation> where <level>", "it is <relation>, which has a reading for tables seen from above; <level>",
          "top where all is level", ("spatial",)),
    _form("another kind is named more", "more words name another kind of container", "another kind is named more",
          ("kind",)),
    _form("number of all things", "it is how many things there are", "number of all things", ("cardinal",)),
    _form("not named", "no own word may name it", "not named", CONCRETE),
    _form("is <symbol>", "it is <symbol>", "is spatial(left)", CONCRETE),
    _form("in <part>", "<part> is grounded to it too", "in mod", CONCRETE),
    # objects
    *(_form(form.template, "it is among: " + form.meaning, form.example, ("object",)) for form in SETS),
    _form("member <fit>", "it is a member of an arrangement: <fit>", "member only[evident]", ("object",)),
    _form("in own <kind>", "it is in the container that the phrase itself means: <kind>", "in own row", ("object",)),
    _form("in <part>", "it is among what <part> is grounded to", "in mod", ("object",)),
    _form("is <part>", "it is the one thing that <part> is grounded to", "is head", ("object",)),
    _form("furniture of own container", "a hand, where the phrase means the robot", "furniture of own container",
          ("object",)),
    _form("furniture of own type", "furniture of the type that is said", "furniture of own type", ("object",)),
    _form("furniture named", "furniture that an own word may name", "furniture named", ("object",)),
    _form("furniture of <part>", "furniture that <part> is grounded to", "furniture of inner", ("object",)),
    _form("ranked[<ref>|<who>]", "of <ref>, the one that the attribute of <who> ranks", "ranked[mod.in|head]",
          ("object",)),
    _form("some <way>", "it is among: <way>", "some nth", ("object",)),
    _form("in own container", "it is in a container that the phrase itself means", "in own container", ("object",)),
    _form("outside own container", "it is in none of the containers that the phrase itself means",
          "outside own container", ("object",)),
    _form("in <share> of <few>", "it is among what <share> of the children are grounded to; of these there are <few>",
          "in all of 2", ("object",)),
    _form("in no set", "it is in no set that the phrase names", "in no set", ("object",)),
    _form("furniture unsaid", "furniture that no phrase speaks of", "furniture unsaid", ("object",)),
    # containers
    *(_form(form.template, "it is " + form.meaning, form.example, ("container",)) for form in FITS),
    *(_form(form.template, "a group, of just: " + form.meaning, form.example, ("container",)) for form in SETS),
    _form("<look>", "<look>", "as it looks", ("container",)),
    _form("<kind> <look>", "a <kind>; <look>", "row as it looks", ("container",)),
    _form("some set <look>", "its members are a named set; <look>", "some set as it looks", ("container",)),
    _form("<set> <look>", "its members are just: <set>; <look>", "k[all|own|own] as it looks", ("container",)),
    _form("some <way>", "its members are: <way>", "some k", ("container",)),
    _form("some <way> <look>", "its members are: <way>; <look>", "some k as it looks", ("container",)),
    _form("<carried>", "<carried>", "carried upward, the only one", ("container",)),
    _form("carried upward, kind said", "a child is grounded to it, and its kind is said", "carried upward, kind said",
          ("container",)),
    _form("carried upward, other kind said", "a child is grounded to it, and another kind is said",
          "carried upward, other kind said", ("container",)),
    _form("part of <part>", "it lies within the container of <part>", "part of mod", ("container",)),
    _form("part of <part>, <same> kind", "it lies within the container of <part>, which is of <same> kind",
          "part of mod, same kind", ("container",)),
    _form("kind said", "its kind is said", "kind said", ("container",)),
    _form("other kind said", "another kind than its own is said", "other kind said", ("container",)),
    _form("kind <kind>", "its kind is: <kind>", "kind row", ("container",)),
    _form("count said", "it has as many members as is said", "count said", ("container",)),
    _form("other count said", "it has not as many members as is said", "other count said", ("container",)),
    _form("unwanted members", "some members have not the type or colour that is said", "unwanted members",
          ("container",)),
    _form("<kind> of <count>", "a <kind> of <count> members", "row of 3", ("container",)),
    _form("<kind> <measure> <kernel> <bin>", "how good a <kind> it is: <measure>; <kernel> kernel, bin <bin>",
          "row fit se 3", ("container",)),
    _form("objects of <part>", "a group, of just what <part> is grounded to", "objects of mod", ("container",)),
    _form("robot of <who>", "the robot's hands, where <who> speaks of it", "robot of own", ("container",)),
    _form("robot unsaid", "the robot's hands, where nobody speaks of them", "robot unsaid", ("container",)),
    _form("named by nothing", "a set that nothing names", "named by nothing", ("container",)),
    # attributes
    _form("type <said>", "its type is said by <said>", "type own", ("attribute", "collection")),
    _form("color <said>", "its colour is said by <said>", "color head", ("attribute", "collection")),
    _form("relation <said>", "its spatial reference is said by <said>", "relation mod", ("attribute", "collection")),
    _form("index <said>", "its rank is said by <said>", "index first", ("attribute",)),
    _form("ranks <said>|<said2>", "its spatial reference is said by <said>; its rank by <said2>", "ranks mod|first",
          ("attribute",)),
    _form("number <said>", "its number is said by <said>", "number counted", ("collection",)),
    _form("all <said>|<said2>|<said3>|<said4>",
          "type said by <said>; colour by <said2>; spatial reference by <said3>; number by <said4>",
          "all own|none|none|own", ("collection",)),
    # regions
    _form("region made", "it is made of a direction and what a child is grounded to", "region made", ("region",)),
    _form("relation of <said>", "its direction is said by <said>", "relation of word", ("region",)),
    _form("relation <relation>", "its direction is <relation>", "relation left", ("region",)),
    *(_form(form.template, form.meaning, form.example, ("region",)) for form in HOWS),
    _form("<how>|<said>", "<how>; its direction is said by <said>", "container of inner|word", ("region",)),
    _form("<relation>|<target>", "<relation> of: <target>", "left|row", ("region",)),
    _form("between one", "between, of one thing alone", "between one", ("region",)),
    # actions
    *(_form(form.template, form.meaning, form.example, ("action",)) for form in (*TARGETS, *GOALS)),
    _form("kind unsaid", "its kind is not said", "kind unsaid", ("action",)),
    _form("kind <action>", "its kind is <action>", "kind pick", ("action",)),
    _form("<acted>|<goal>", "<acted>, <goal>", "the object|to region", ("action",)),
    _form("<action>|<goal>", "<action>, <goal>", "place|to region", ("action",)),
    # what a child grounded to and the phrase takes over
    _form("is <part>", "<part> is grounded to it", "is inner",
          ("container", "attribute", "collection", "region", "action")),
)  # fmt: skip


def explain_fact(name: str, family: str | None = None) -> Explained | None:
    """What a fact of the context means; None if no form fits."""
    return first_of(FACTS, name, family)


def explain_role(name: str, family: str | None = None) -> Explained | None:
    """What a role of a symbol means in a family's factor; None if no form fits."""
    return first_of(ROLES, name, family)
