#!/usr/bin/perl
# A client of the oracle in Perl: an operation a line, the places of its inputs that are above zero and what it makes of them;
# nothing where they lie outside the domain. It skips what it does not have.
use strict; use warnings;
sub cube { $_[0]**3 }
sub norm { sqrt($_[0]**2 + $_[1]**2 + $_[2]**2) }
my %op = (
  eq03 => [[0,1,2,3], sub { my ($W,$k,$m1,$m2,$Q,$x,$y,$z,$vx,$vy,$vz) = @_;
     return unless $x || $y || $z;
     my $s = 1 + $m1/$m2; my $L = $s*norm($x,$y,$z); my $f = $k/$m1*$s/cube($L)*$Q;
     (2*$W*$vy + 3*$W**2*$x + $f*$x, -2*$W*$vx + $f*$y, -$W**2*$z + $f*$z) }],
  eq04 => [[0,1], sub { my ($m1,$m2,@r) = @_; map { -$m1/$m2*$_ } @r }],
  eq05 => [[0,1,2], sub { my ($m1,$m2,$L) = @_; ($m2/($m1+$m2)*$L, -$m1/($m1+$m2)*$L) }],
  eq07 => [[0..4], sub { my ($W,$k,$m1,$m2,$L) = @_; -3*$W**2*cube($L)/$k*($m1*$m2/($m1+$m2)) }],
  eq09 => [[], sub { my ($p,$t) = @_;
     (cos($t)*cos($p), cos($t)*sin($p), -sin($t), -sin($p), cos($p), 0, sin($t)*cos($p), sin($t)*sin($p), cos($t)) }],
  eq10 => [[0,1,2], sub { my ($m1,$m2,$L,$p,$t) = @_; my $r = $m2/($m1+$m2)*$L; ($r*cos($t)*cos($p), $r*cos($t)*sin($p), -$r*sin($t)) }],
  eq10inv => [[0,1], sub { my ($m1,$m2,$x,$y,$z) = @_; return unless $x || $y || $z;
     (($m1+$m2)/$m2*norm($x,$y,$z), $x || $y ? atan2($y,$x) : 0, atan2(-$z, sqrt($x**2+$y**2))) }],
  eq12 => [[], sub { my @r = @_; my $L = norm($r[0]-$r[3], $r[1]-$r[4], $r[2]-$r[5]); $L > 0 ? $L : () }],
  eq13 => [[0,1], sub { my ($m1,$m2,@r) = @_; my $L = ($m1+$m2)/$m2*norm(@r); $L > 0 ? $L : () }],
  eq15 => [[0..4], sub { my ($W,$k,$m1,$m2,$L,$pd,$Q) = @_; (2*$W*$pd + 3*$W**2)*$L + $k/$m1*$Q/$L**2*(($m1+$m2)/$m2) }],
  eq18 => [[0..3], sub { my ($k,$m1,$m2,$Lr,$C1,$C2,$d,$dd) = @_; $m1*$m2*$Lr**2/(($m1+$m2)*$k)*(-$C1*$d - $C2*$dd) }],
  eq19 => [[0,1], sub { my ($W,$Lr,$C1,$C2,$d,$dd,$pd) = @_; -($C1 - 9*$W**2)*$d - $C2*$dd + 2*$W*$Lr*$pd }],
  eq21 => [[], sub { my ($Q,$dQ) = @_; $Q + $dQ < 0 ? (sqrt(-($Q+$dQ)), -sqrt(-($Q+$dQ))) : () }],
  eq25 => [[0], sub { my ($W,$t) = @_; (-$W*sin($t), 0, $W*cos($t)) }],
  eq32 => [[0,1,2], sub { my ($m1,$m2,$L) = @_; $m1*$m2/($m1+$m2)*$L**2 }],
  eq37 => [[0], sub { my ($GM,@r) = @_; my $I = pop @r; my $R = norm(@r); return unless $R > 0 && $I >= 0;
     my $k = 3*$GM/$R**5; my @h = (0, $I*$r[1], $I*$r[2]);              # r x (I r)
     ($k*($r[1]*$h[2]-$r[2]*$h[1]), $k*($r[2]*$h[0]-$r[0]*$h[2]), $k*($r[0]*$h[1]-$r[1]*$h[0])) }],
  eq38 => [[0,1], sub { my ($GM,$R) = @_; sqrt($GM/cube($R)) }],
  eq40 => [[0,1], sub { my ($W,$Lr,$C1,$C2,$p,$t,$d,$dd,$pd) = @_;
     (-4*$W**2*$t, -2*$W/$Lr*$dd - 3*$W**2*$p, -$C2*$dd + 2*$W*$Lr*$pd - ($C1 - 9*$W**2)*$d) }],
  eq43 => [[0,1], sub { $_[1]*$_[0]**2 }],
  eq44 => [[0], sub { $_[1] >= 9 ? 2*$_[0]*sqrt($_[1] - 9) : () }],
  flow_linear => [[0,1], sub { my ($W,$Lr,$C1,$C2,$t,@s) = @_; flow($W,$Lr,$C1,$C2,$t,\@s) }],
);
sub flow {   # Runge-Kutta in radians of orbit, lengths over L_ref
  my ($W,$Lr,$C1,$C2,$t,$s) = @_;
  my ($c1,$c2,$tau) = ($C1/$W**2, $C2/$W, $W*$t);
  my $n = 1 + int(abs($tau)/0.001); my $h = $tau/$n;
  my @y = ($s->[0],$s->[1],$s->[2]/$Lr,$s->[3]/$W,$s->[4]/$W,$s->[5]/$W/$Lr);
  my $f = sub { my @y = @_; ($y[3],$y[4],$y[5], -2*$y[5]-3*$y[0], -4*$y[1], -$c2*$y[5]+2*$y[3]-($c1-9)*$y[2]) };
  for (1..$n) {
    my @a = $f->(@y); my @b = $f->(map { $y[$_]+$h/2*$a[$_] } 0..5);
    my @c = $f->(map { $y[$_]+$h/2*$b[$_] } 0..5); my @d = $f->(map { $y[$_]+$h*$c[$_] } 0..5);
    @y = map { $y[$_] + $h/6*($a[$_]+2*$b[$_]+2*$c[$_]+$d[$_]) } 0..5;
  }
  ($y[0],$y[1],$y[2]*$Lr,$y[3]*$W,$y[4]*$W,$y[5]*$W*$Lr);
}
while (my $line = <STDIN>) {
  my ($id, $vector, @in) = split ' ', $line;
  my $o = $op{$id};
  unless ($o) { print "$vector skip not in Perl yet\n"; next }
  my $ok = !grep { /inf|nan/i } @in;
  my @x = $ok ? map { 0 + $_ } @in : ();
  $ok &&= !grep { $x[$_] <= 0 } @{$o->[0]};
  my @out = $ok ? $o->[1]->(@x) : ();
  my $text = @out ? join(' ', map { sprintf '%.17g', $_ } @out) : 'invalid';
  print "$vector $text\n";
}
