# YAML files as lines: file and path, number or text, value. Perl has one kind of scalar: what is a decimal number is one.
use strict;
use warnings;
use YAML::XS;
binmode STDOUT, ':encoding(UTF-8)';

# Keys in no order: the lines are sorted by who compares them.
sub walk {
    my ($path, $value) = @_;
    if (ref $value eq 'HASH') {
        walk("$path/$_", $value->{$_}) for keys %$value;
    } elsif (ref $value eq 'ARRAY') {
        walk("$path/$_", $value->[$_]) for 0 .. $#$value;
    } elsif (!defined $value || ref $value) {
        print join("\t", $path, 'other', $value // 'undef'), "\n";
    } elsif ($value =~ /\A[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\z/) {
        print join("\t", $path, 'number', unpack('H*', pack('d>', $value))), "\n";
    } else {
        $value =~ s/\n/\\n/g;
        print join("\t", $path, 'text', $value), "\n";
    }
}

walk($_, YAML::XS::LoadFile($_)) for @ARGV;
