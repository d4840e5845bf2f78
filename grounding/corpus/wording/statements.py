"""Productions of statements: what moves where, what should be moved, what there is."""

TEXT = """
[moves]
moves 10 : moves
goes 4 : goes
shifts 2 : shifts
slides 2 : slides
jumps 0.4 : jumps|drops|leaps|falls|hops|travels/VBZ
comes 0.3 : comes

[mover]
block 10 : <block>
ranked 6 : (NP the <rank> <noun>)
where 4 : (NP (NP the <noun>) <where>)
stack.top 2 @stacked : (NP (NP the top/NN) (PP of <stack>))
pronoun 1 @history : <pronoun>
nth.rank 1 : (NP the <ordinal> <edgemost> <noun>)

[statement.core]
moves.path 12 : (S <mover> (VP <moves> <path>))
moves.destination 10 : (S <mover> (VP <moves> <destination>))
moves.twice 2 @distance : (S <mover> (VP <moves> (PP <path> then|and <path>)))
moves.until 1.5 : (S <mover> (VP <moves> <path> <until>))
moves.result 1 : (S <mover> (VP <moves> <destination> <result>))
goes.onto 3 @stacked : (S <mover> (VP goes|moves|jumps|sits/VBZ <onto>))
is.placed 2.5 : (S <mover> (VP is (VP placed|moved|put|stacked|positioned/VBN <destination>)))
should.be 2.5 : (S <mover> (VP should|must|will (VP be (VP placed|moved|put|stacked/VBN <destination>))))
should.move 1.5 : (S <mover> (VP should|will (VP move|go|slide/VB <destination>)))
needs.to 1 : (S <mover> (VP needs (S (VP to/TO (VP be (VP moved|placed/VBN <destination>))))))
needs.to.move 0.6 : (S <mover> (VP needs (S (VP to/TO (VP move|go/VB <destination>)))))
gets 0.5 : (S <mover> (VP gets (VP moved|placed/VBN <destination>)))
joins 2 : (S <mover> (VP joins <reference>))
joins.to 0.8 @arrangement : (S <mover> (VP joins <reference> (S (VP to/TO (VP form|make|create/VB <set.new>)))))
loses 1.5 @stacked : (S <stack> (VP loses <lost>))
loses.to 1 @stacked : (S <stack> (VP loses <lost> (PP to <reference>)))
loses.moves 1 @stacked : (S <stack> (VP loses <lost> (SBAR (WHNP which) (S (VP <moves> <path>)))))
takes 1.2 : (S <reference> (VP takes <block.brief>))
takes.from 1 : (S <reference> (VP takes <block.brief> (PP from <reference>)))
becomes 1 : (S <mover> (VP becomes <becoming>))
forms 1.2 @arrangement : (S <mover> (VP forms <set.new> (PP with <reference>)))
forms.at 0.5 @arrangement : (S <mover> (VP forms <set.new> <location>))
touches 0.3 : (S <mover> (VP moves (S (VP to/TO (VP touch <reference>)))))
of.those 1 @arrangement : (S (PP of <plural.front>) <choice.np> (VP <moves> <destination>))
bare.to 0.5 @loose : (NP <block.brief> <onto>)
is.moved.until 0.7 : (S <mover> (VP is (VP moved|shifted|pushed/VBN <path> <until>)))
from.to 1.5 : (S <mover> (VP <moves> (PP from <reference>) <destination.pp>))
is.taken 0.5 @stacked : (S <mover> (VP is (VP taken|removed/VBN (PP from|off <stack>))))
gains 0.7 @stacked : (S <stack> (VP gains|adds/VBZ <lost>))
now.moves 0.7 : (S <mover> (VP now/RB <moves> <destination>))
shares 0.3 : (S <mover> (VP <moves> <path> \
    (S (VP to/TO (VP share/VB (NP a|its <edge.word> edge|side) (PP with <reference>))))))

[choice.np]
choice 1 @arrangement : <block.choice>

[lost]
its.top 4 @stacked : (NP its top block|box|cube|piece|brick)
a.block 3 @stacked : (NP a block|box|cube|piece)
top.one 0.6 @stacked : (NP the top one/NN)

[becoming]
top 3 @stacked : (NP (NP the top/NN) (PP of <stack>))
ordinal 2 : (NP (NP the <ordinal> block|box) (PP in <set.plain>))
new 2 @arrangement : <set.new>
story 0.6 @stacked : (NP (NP the second|third|fourth story) (PP of|in <stack>))

[set.plain]
any 1 @arrangement : <set.simple>

[there.is]
one 5 : (S (NP there/EX) (VP is (NP (NP a <lone>?.3 <color>?.5 <noun>) <where>)))
one.ranked 1 : (S (NP there/EX) (VP 's/VBZ (NP (NP a <color>?.5 <noun>) <where>)))
several 5 : (S (NP there/EX) (VP are (NP (NP <number> <color>?.6 <nouns>) <where>)))
several.bare 1.5 : (S (NP there/EX) (VP are (NP <number> <color>?.8 <nouns>)))
several.that 0.8 : (S (NP there/EX) (VP are (NP (NP <number> <color>?.6 <nouns>) <that.are>)))
set 2 @arrangement : (S (NP there/EX) (VP is (NP (NP (NP a <set.noun>) (PP of (NP <number> \
    <color>?.5 <nouns>))) <where>)))
stack 1.5 @stacked : (S (NP there/EX) (VP is (NP (NP a <stack.noun>) <where>)))
place.first 0.8 : (S <location> (VP is|are (NP (NP <number> <color>?.6 <nouns>) <in.formation>?.3)))
the.block.is 1 : (S (NP <base>) (VP is <where>))

[target.is]
target 2 : (S (NP your|the target) (VP is <block>))
it 2 : (S (NP it) (VP <is> <block>))
it.where 2 : (S (NP it) (VP <is> <where>))
the.block.is 2 : (S (NP the|that|this/DT block|box|cube|one/NN) (VP is <where>))
that.one 0.5 : (S (NP that/DT) (VP <is> <block>))
the.one.you.want 1 @viewer : (S (NP (NP the <noun>) (SBAR (S (NP you|i) (VP want|need/VBP)))) (VP is <block>))
closest.is 0.5 @viewer @color : (S (NP (NP the closest|nearest <noun>) (PP to <person>)) (VP is (ADJP <color>)))

[wish.pick]
want 3 @viewer : (S (NP i) (VP want|need/VBP <block>))
you.want 3 @viewer : (S (NP you) (VP want/VBP <block>))
want.you 3 @viewer : (S (NP i) (VP want/VBP (S (NP you) (VP to/TO <pick.vp>))))
you.want.to 2 @viewer : (S (NP you) (VP want|need/VBP (S (VP to/TO <pick.vp>))))
would.like 2 @viewer : (S (NP i) (VP would (VP like (S (NP you) (VP to/TO <pick.vp>)))))
would.like.block 1 @viewer : (S (NP i) (VP would (VP like <block>)))
d.like 0.6 @viewer : (S (NP i) (VP 'd/MD (VP like (S (NP you) (VP to/TO <pick.vp>)))))
tell.robot 0.8 @viewer : (S (NP i) (VP would (VP tell|ask (NP the robot) (S (VP to/TO <pick.vp>)))))
you.should 0.6 @viewer : (S (NP you) (VP should|must|will <pick.vp>))
are.to 0.3 @viewer : (S (NP you) (VP are (S (VP to/TO <pick.vp>))))

[wish.place]
want.you 3 @viewer : (S (NP i) (VP want/VBP (S (NP you) (VP to/TO <place.vp>))))
would.like 2 @viewer : (S (NP i) (VP would (VP like (S (NP you) (VP to/TO <place.vp>)))))
want.block 0.4 @viewer : (S (NP i) (VP want/VBP <block.brief> <destination>))
you.should 0.6 @viewer : (S (NP you) (VP should|must|will <place.vp>))
"""
